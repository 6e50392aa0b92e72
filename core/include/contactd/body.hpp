// The two bodies of a contact: their materials, and the origins of their influence coefficients.
#pragma once

#include <optional>
#include <variant>

#include "contactd/given_ics.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/material.hpp"

namespace contactd {

/// A standard linear solid: its creep compliance is J(t) = (1 + f (1 - exp(-t/tau)))/G, with G and nu of its
/// instantaneous material and constant nu. The relaxation time of its stress is tau/(1 + f). For steady rolling along
/// x.
struct Viscoelasticity {
    double f = 0;    ///< delayed over instantaneous compliance, >= 0
    double tau = 0;  ///< retardation time of creep (s), >= 0

    bool operator==(const Viscoelasticity&) const = default;
};

/// Coefficients by a source that computes them, or in a table of the request.
using Coefficients = std::variant<Ics, GivenIcs>;

struct Body {
    Material material;                              ///< or rigid; for layers, that of their surface
    Coefficients ics{};                             ///< of the body alone; not used if it is rigid
    std::optional<Viscoelasticity> viscoelastic{};  ///< for half-spaces in closed form

    /// Returns the table in the request, or null. A rigid body has none.
    const GivenIcs* given() const;
    /// Returns the source of a table, or null if no table is computed.
    const Ics* computed() const;
    /// Returns the layers of a layered body, or null.
    const Layers* layered() const;
    /// Returns the section of a longitudinally uniform body, or null.
    const Section* section() const;
    /// One of layers.
    static Body of(const Layers& layers, LoadShape load_shape = LoadShape::constant);

    bool operator==(const Body&) const = default;
};

struct Bodies {
    Body upper, lower;
    /// Coefficients of the pair (pair_of), which replace those of upper and lower.
    std::optional<GivenIcs> pair{};

    MaterialPair materials() const { return {upper.material, lower.material}; }
    /// Coefficients of both from one source.
    static Bodies of(const MaterialPair& materials, const Ics& ics = {}) {
        return {{materials.upper, ics}, {materials.lower, ics}};
    }
    /// Returns whether the request contains coefficients, of the pair or of a body.
    bool any_given() const;
    /// Returns whether one of them has layers; closed forms of half-spaces do not apply then.
    bool any_layered() const;
    /// Returns whether one of them is viscoelastic.
    bool any_viscoelastic() const;
    /// Returns whether one of them is longitudinally uniform; closed forms do not apply then either.
    bool any_uniform() const;

    bool operator==(const Bodies&) const = default;
};

/// Returns the bodies with those of instantaneous or no creep as elastic: for tau = 0 the modulus is G/(1 + f).
Bodies without_instant_creep(Bodies bodies);

/// Returns the line contact of the bodies' coefficients; none without one, or for coefficients of a pair.
std::optional<LineContactSpec> line_contact_of(const Bodies& bodies);

/// Throws InvalidArgument naming the field as on the wire if they cannot be in contact on `grid`.
void validate(const Bodies& bodies, const Grid& grid);

}  // namespace contactd

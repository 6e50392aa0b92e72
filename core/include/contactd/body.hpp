// Defines the two bodies of a contact: their materials, and the sources of their influence coefficients.
#pragma once

#include <optional>
#include <variant>

#include "contactd/given_ics.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/material.hpp"

namespace contactd {

/// Describes a standard linear solid, for steady rolling along x. Its creep compliance is J(t) = (1 + f (1 -
/// exp(-t/tau)))/G, with G and nu of the instantaneous material; nu is constant. The relaxation time of its stress is
/// tau/(1 + f).
struct Viscoelasticity {
    double f = 0;    ///< delayed over instantaneous compliance, >= 0
    double tau = 0;  ///< retardation time of creep (s), >= 0

    bool operator==(const Viscoelasticity&) const = default;
};

/// Influence coefficients are computed from a source, or given as a table in the request.
using Coefficients = std::variant<Ics, GivenIcs>;

struct Body {
    Material material;                              ///< may be rigid; for layers, the material of the surface
    Coefficients ics{};                             ///< coefficients of this body alone; unused if it is rigid
    std::optional<Viscoelasticity> viscoelastic{};  ///< for half-spaces in closed form

    /// Returns the table in the request, or null. A rigid body has none.
    const GivenIcs* given() const;
    /// Returns the source from which the coefficients are computed, or null if they are given.
    const Ics* computed() const;
    /// Returns the layers of a layered body, or null.
    const Layers* layered() const;
    /// Returns the section of a longitudinally uniform body, or null.
    const Section* section() const;
    /// Returns a body of layers.
    static Body of(const Layers& layers, LoadShape load_shape = LoadShape::constant);

    bool operator==(const Body&) const = default;
};

struct Bodies {
    Body upper, lower;
    /// Holds the coefficients of the pair (pair_of), which replace those of upper and lower.
    std::optional<GivenIcs> pair{};

    MaterialPair materials() const { return {upper.material, lower.material}; }
    /// Returns bodies whose coefficients come from the same source.
    static Bodies of(const MaterialPair& materials, const Ics& ics = {}) {
        return {{materials.upper, ics}, {materials.lower, ics}};
    }
    /// Returns whether the request contains coefficients of the pair or of a body.
    bool any_given() const;
    /// Returns whether one of the bodies has layers. Closed forms of half-spaces do not apply then.
    bool any_layered() const;
    /// Returns whether one of the bodies is viscoelastic.
    bool any_viscoelastic() const;
    /// Returns whether one of the bodies is longitudinally uniform. Closed forms of half-spaces do not apply then.
    bool any_uniform() const;

    bool operator==(const Bodies&) const = default;
};

/// Returns the bodies with those of instantaneous or no creep replaced by elastic ones: for tau = 0 the modulus is G/(1
/// + f).
Bodies without_instant_creep(Bodies bodies);

/// Returns the line contact of the bodies' coefficients, or nothing if there is none or the pair's coefficients are
/// given.
std::optional<LineContactSpec> line_contact_of(const Bodies& bodies);

/// Throws InvalidArgument, which names the field as on the wire, if the bodies cannot be in contact on `grid`.
void validate(const Bodies& bodies, const Grid& grid);

}  // namespace contactd

// The two bodies of a contact: what each is made of, and where its influence coefficients come from.
#pragma once

#include <optional>
#include <variant>

#include "contactd/given_ics.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/material.hpp"

namespace contactd {

/// The standard linear solid: its creep compliance is J(t) = (1 + f (1 - exp(-t/tau)))/G, G and nu those of its
/// material at once; Poisson's ratio stays. The relaxation time of its stress is tau/(1 + f). Of steady rolling along
/// x.
struct Viscoelasticity {
    double f = 0;    ///< delayed compliance over that at once, >= 0
    double tau = 0;  ///< retardation time of creep (s), >= 0

    bool operator==(const Viscoelasticity&) const = default;
};

/// By a source that makes them, or a table that the request brings along.
using Coefficients = std::variant<Ics, GivenIcs>;

struct Body {
    Material material;                              ///< or rigid; of layers that of their surface
    Coefficients ics{};                             ///< of the body alone; of no meaning when it is rigid
    std::optional<Viscoelasticity> viscoelastic{};  ///< of half-spaces by their closed form

    /// A table that the request brings along, or null: a rigid body has none.
    const GivenIcs* given() const;
    /// The source of a table, or null where there is none to make.
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
    /// The coefficients of both together (pair_of) instead; upper and lower mean nothing then.
    std::optional<GivenIcs> pair{};

    MaterialPair materials() const { return {upper.material, lower.material}; }
    /// Coefficients of both from one source.
    static Bodies of(const MaterialPair& materials, const Ics& ics = {}) {
        return {{materials.upper, ics}, {materials.lower, ics}};
    }
    /// Whether the request brings coefficients along, of the pair or of a body.
    bool any_given() const;
    /// Whether one of them is made of layers, of which the closed forms of half-spaces say nothing.
    bool any_layered() const;
    /// Returns whether one of them creeps.
    bool any_viscoelastic() const;
    /// Whether one of them is a longitudinally uniform body, of which they say nothing either.
    bool any_uniform() const;

    bool operator==(const Bodies&) const = default;
};

/// Returns the bodies with what creeps at once, or not at all, made elastic: of tau = 0 the modulus is G/(1 + f).
Bodies without_instant_creep(Bodies bodies);

/// The line contact that the bodies' coefficients are computed for; nothing where there is none, or they are a pair's.
std::optional<LineContactSpec> line_contact_of(const Bodies& bodies);

/// Throws InvalidArgument naming the field as on the wire when they cannot be in contact on `grid`.
void validate(const Bodies& bodies, const Grid& grid);

}  // namespace contactd

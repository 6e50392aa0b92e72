// Describes a layered body: one or more layers, bonded to each other and to their base, uniform along x and y.
#pragma once

#include <vector>

#include "contactd/material.hpp"

namespace contactd {

struct Layer {
    double thickness = 0;  ///< mm, > 0
    double G = 0;          ///< shear modulus (N/mm^2), > 0
    double nu = 0;         ///< Poisson's ratio, 0 <= nu <= 0.5; 0.5 is exact incompressibility

    constexpr Material material() const { return {G, nu}; }
    bool operator==(const Layer&) const = default;
};

struct Layers {
    std::vector<Layer> layers;  ///< from the surface down
    Material base;              ///< the half-space below them, or rigid: no displacement at the end of the last layer

    /// Returns the material of the surface.
    Material surface() const { return layers.front().material(); }
    bool operator==(const Layers&) const = default;
};

/// Coefficients are tested within these limits: the number of layers, the ratio of shear moduli, and thicknesses over
/// dx.
inline constexpr int most_layers = 20;
inline constexpr double largest_layer_contrast = 1e9;
inline constexpr double thinnest_layer = 1e-6, thickest_layer = 1e6;

/// Throws InvalidArgument below `field`, such as "ics.layers[1].thickness", if no coefficients can be computed for
/// elements of length `dx` along x.
void validate(const Layers& body, double dx, const char* field);

}  // namespace contactd

// A body of layers: one or more of them, bonded to each other and to what they lie on, uniform along x and y.
#pragma once

#include <vector>

#include "contactd/material.hpp"

namespace contactd {

struct Layer {
    double thickness = 0;  ///< mm, > 0
    double G = 0;          ///< shear modulus (N/mm^2), > 0
    double nu = 0;         ///< Poisson's ratio, 0 <= nu <= 0.5; 0.5 is meant exactly

    constexpr Material material() const { return {G, nu}; }
    bool operator==(const Layer&) const = default;
};

struct Layers {
    std::vector<Layer> layers;  ///< from the surface down
    Material base;              ///< the half-space below them, or rigid: no displacement where the last layer ends

    /// Returns the material of the surface.
    Material surface() const { return layers.front().material(); }
    bool operator==(const Layers&) const = default;
};

/// Limits that the coefficients were tested for: the number of layers, how far shear moduli may differ, and thicknesses
/// over dx.
inline constexpr int most_layers = 20;
inline constexpr double largest_layer_contrast = 1e9;
inline constexpr double thinnest_layer = 1e-6, thickest_layer = 1e6;

/// Throws InvalidArgument below `field`, such as "ics.layers[1].thickness", when no coefficients can be computed for
/// elements of length `dx` along x.
void validate(const Layers& body, double dx, const char* field);

}  // namespace contactd

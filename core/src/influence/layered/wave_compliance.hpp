// The surface of a layered body under tractions that are waves: its compliance in the plane of the wave vector and
// across it.
#pragma once

#include <array>
#include <vector>

#include "contactd/layers.hpp"

namespace contactd {

/// G k times the compliance, G of the topmost layer: with tractions times exp(i k.x), p along the wave vector and s
/// across it, u_p = a t_p - i b t_z, u_z = i b t_p + c t_z, u_s = d t_s. A half-space has 1-nu, (1-2nu)/2, 1-nu and 1.
struct WaveCompliance {
    double a, b, c, d;
};

/// By a Riccati recursion for the compliance from the base up to the surface, through slices of the layers in which the
/// propagator of the state (u_x, u_z, t_x, t_z) has a closed form without cancellation, whatever k and nu (0.5, too).
class LayeredWaves {
   public:
    explicit LayeredWaves(const Layers& body);

    /// At the wavenumber k > 0 (1/mm). Relative error of the largest component 1e-14 or less.
    WaveCompliance at(double k) const;

   private:
    using Matrix2 = std::array<double, 4>;   // row by row
    using Matrix4 = std::array<double, 16>;  // row by row

    struct Surface {
        Matrix2 plane{};    // displacements in the plane (x, z) under tractions there
        double across = 0;  // all are zero on a rigid base
    };
    struct Slab {
        double thickness;
        double contrast;   // shear modulus of this layer over that of what lies below it; 0 on a rigid base
        Matrix2 deep;      // compliance of a half-space of this material
        Matrix4 A, N, AN;  // the state changes by A d(kz); A^2 - 1, and their product

        Slab(const Layer& layer, double contrast);
        /// From the surface of what lies below to that of the layer.
        void raise(double k, Surface& surface) const;
    };
    static Matrix2 half_space(double nu);

    std::vector<Slab> slabs_;  // from the base up
    Surface base_;
};

}  // namespace contactd

// Represents one layer under tractions that are waves: from the material below it to its surface, and from its surface
// down.
#pragma once

#include <array>

#include "contactd/layers.hpp"

namespace contactd {

using Matrix2 = std::array<double, 4>;   // row by row
using Matrix4 = std::array<double, 16>;  // row by row

/// Holds G k times the displacements under unit tractions of a surface, with G of the material below it. In the plane
/// (x, z) of the wave, displacements are U sin kx, W cos kx under t_x sin kx, t_z cos kx. All are zero on a rigid base.
struct WaveSurface {
    Matrix2 plane{};
    double across = 0;

    static WaveSurface half_space(double nu);
};

/// Holds the part of unit tractions on the surface that remains at some depth: in the plane, and across it.
struct WaveTransmission {
    Matrix2 plane{1, 0, 0, 1};
    double across = 1;
};

/// Returns derivatives of the state (U, W, t_x, t_z) of a material with respect to k z, tractions over G k. They are
/// finite at nu = 1/2.
Matrix4 wave_generator(double nu);

class LayerSlab {
   public:
    /// `contrast` is the shear modulus of this layer over that of the material below it; 0 on a rigid base.
    LayerSlab(const Layer& layer, double contrast);

    /// Updates `surface` from that of the material below to that of the layer, and `down`, if given, from the
    /// transmission below to that through this layer. The closed form of the propagator neither grows nor cancels,
    /// whatever k and nu.
    void raise(double k, WaveSurface& surface, WaveTransmission* down = nullptr) const;

   private:
    double thickness_, contrast_;
    WaveSurface deep_;    // surface of a half-space of this material
    Matrix4 A_, N_, AN_;  // the state changes by A d(kz); A^2 - 1, and their product
};

}  // namespace contactd

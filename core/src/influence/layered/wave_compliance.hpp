// Computes the compliance of the surface of a layered body under tractions that are waves, in the plane of the wave
// vector and across it.
#pragma once

#include <vector>

#include "contactd/layers.hpp"
#include "influence/layered/layer_slab.hpp"

namespace contactd {

/// Holds G k times the compliance, with G of the topmost layer. With tractions times exp(i k.x), p along the wave
/// vector and s across it, u_p = a t_p - i b t_z, u_z = i b t_p + c t_z, u_s = d t_s. A half-space has 1-nu, (1-2nu)/2,
/// 1-nu and 1.
struct WaveCompliance {
    double a, b, c, d;
};

/// Computes the compliance by a Riccati recursion from the base up to the surface. In the slices of the layers, the
/// propagator of the state (u_x, u_z, t_x, t_z) has a closed form without cancellation, whatever k and nu (0.5, too).
class LayeredWaves {
   public:
    explicit LayeredWaves(const Layers& body);

    /// Returns the compliance at the wavenumber k > 0 (1/mm). The relative error of the largest component is at most
    /// 1e-14.
    WaveCompliance at(double k) const;

   private:
    std::vector<LayerSlab> slabs_;  // from the base up
    WaveSurface base_;
};

}  // namespace contactd

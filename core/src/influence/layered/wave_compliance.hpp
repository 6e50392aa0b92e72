// The surface of a layered body under tractions that are waves: its compliance in the plane of the wave vector and
// across it.
#pragma once

#include <vector>

#include "contactd/layers.hpp"
#include "influence/layered/layer_slab.hpp"

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
    std::vector<LayerSlab> slabs_;  // from the base up
    WaveSurface base_;
};

}  // namespace contactd

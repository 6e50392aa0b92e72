// Computes stresses at a depth of a layered body under tractions that are waves on its surface.
#pragma once

#include <array>
#include <vector>

#include "contactd/layers.hpp"
#include "influence/layered/layer_slab.hpp"

namespace contactd {

/// Holds stresses under a unit traction, in the plane of the wave vector, x along it. t_z cos kx gives xx, yy and zz
/// times cos kx and xz times sin kx; so does t_x sin kx. t_y across the plane gives yz in its own phase, and xy a
/// quarter ahead.
struct StressWave {
    struct Plane {
        double xx, yy, zz, xz;
    };
    Plane of_normal, of_tangential;
    double yz, xy;
};

/// Computes the waves. In the first layer, those of a half-space of its material are subtracted, because they have a
/// closed form in space and need not decay with k near the surface. So all of them decay as exp(-k scale()).
class StressWaves {
   public:
    /// `depth` >= 0 is below the surface (mm), not in a rigid base. On the border of two layers it is in the upper one.
    StressWaves(const Layers& body, double depth);

    /// Returns the stresses at the wavenumber k > 0 (1/mm).
    StressWave at(double k) const;
    double scale() const { return scale_; }  ///< mm
    bool in_first_layer() const { return layer_ == 0; }

   private:
    double depth_, nu_, scale_;
    std::size_t layer_;             // layer that contains the depth; the number of layers for the base
    std::vector<LayerSlab> below_;  // from the base up to the depth
    std::vector<LayerSlab> above_;  // from the depth to the surface
    WaveSurface base_;
};

}  // namespace contactd

#include "influence/layered/wave_compliance.hpp"

namespace contactd {

LayeredWaves::LayeredWaves(const Layers& body) {
    double below = body.base.G;  // infinite for a rigid base
    for (std::size_t i = body.layers.size(); i-- > 0;) {
        slabs_.emplace_back(body.layers[i], body.layers[i].G / below);
        below = body.layers[i].G;
    }
    if (!body.base.is_rigid()) base_ = WaveSurface::half_space(body.base.nu);
}

WaveCompliance LayeredWaves::at(double k) const {
    WaveSurface surface = base_;
    for (const LayerSlab& slab : slabs_) slab.raise(k, surface);
    return {surface.plane[0], (surface.plane[1] + surface.plane[2]) / 2, surface.plane[3], surface.across};
}

}  // namespace contactd

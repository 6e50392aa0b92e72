#include "influence/layered/stress_waves.hpp"

#include <cmath>

namespace contactd {
namespace {

// Returns stresses from the displacement U and the tractions t at the depth, under unit tractions at the surface,
// column by column.
StressWave::Plane stresses(double nu, double U, double tangential, double normal) {
    const double m = nu / (1 - nu);
    return {2 / (1 - nu) * U + m * normal, 2 * m * U + m * normal, normal, tangential};
}

StressWave of_transmitted(double nu, const WaveSurface& surface, const WaveTransmission& down) {
    const Matrix2 &C = surface.plane, &t = down.plane;
    const auto column = [&](std::size_t j) { return stresses(nu, C[0] * t[j] + C[1] * t[2 + j], t[j], t[2 + j]); };
    return {column(1), column(0), down.across, surface.across * down.across};
}

// The decaying part of a half-space's state changes by exp(A x) = exp(x) (1 + x (A - 1)), since (A - 1)^2 = 0 there.
StressWave of_half_space(double nu, double depth) {
    const Matrix4 A = wave_generator(nu);
    const Matrix2 C = WaveSurface::half_space(nu).plane;
    const double decay = std::exp(-depth);
    const auto column = [&](std::size_t j) {
        const std::array<double, 4> state{C[j], C[2 + j], j == 0 ? 1.0 : 0.0, j == 0 ? 0.0 : 1.0};
        std::array<double, 4> there{};
        for (std::size_t i = 0; i < 4; ++i) {
            double change = -state[i];
            for (std::size_t n = 0; n < 4; ++n) change += A[4 * i + n] * state[n];
            there[i] = decay * (state[i] - depth * change);
        }
        return stresses(nu, there[0], there[2], there[3]);
    };
    return {column(1), column(0), decay, decay};
}

StressWave::Plane operator-(const StressWave::Plane& a, const StressWave::Plane& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xz - b.xz};
}

}  // namespace

StressWaves::StressWaves(const Layers& body, double depth) : depth_(depth), layer_(0) {
    const std::vector<Layer>& layers = body.layers;
    double top = 0;  // of the layer
    while (layer_ < layers.size() && depth > top + layers[layer_].thickness) top += layers[layer_++].thickness;
    const bool in_base = layer_ == layers.size();
    nu_ = in_base ? body.base.nu : layers[layer_].nu;
    scale_ = layer_ == 0 ? 2 * layers[0].thickness - depth : depth;

    const auto G_below = [&](std::size_t i) { return i + 1 < layers.size() ? layers[i + 1].G : body.base.G; };
    if (!body.base.is_rigid()) base_ = WaveSurface::half_space(body.base.nu);
    for (std::size_t i = layers.size(); i-- > layer_ + 1;) below_.emplace_back(layers[i], layers[i].G / G_below(i));
    if (in_base) {
        above_.emplace_back(Layer{depth - top, body.base.G, body.base.nu}, 1);
    } else {
        const Layer& here = layers[layer_];
        below_.emplace_back(Layer{top + here.thickness - depth, here.G, here.nu}, here.G / G_below(layer_));
        above_.emplace_back(Layer{depth - top, here.G, here.nu}, 1);
    }
    for (std::size_t i = std::min(layer_, layers.size()); i-- > 0;)
        above_.emplace_back(layers[i], layers[i].G / G_below(i));
}

StressWave StressWaves::at(double k) const {
    WaveSurface surface = base_;
    for (const LayerSlab& slab : below_) slab.raise(k, surface);
    const WaveSurface there = surface;
    WaveTransmission down;
    for (const LayerSlab& slab : above_) slab.raise(k, surface, &down);
    const StressWave wave = of_transmitted(nu_, there, down);
    if (!in_first_layer()) return wave;
    const StressWave half_space = of_half_space(nu_, k * depth_);
    return {wave.of_normal - half_space.of_normal, wave.of_tangential - half_space.of_tangential,
            wave.yz - half_space.yz, wave.xy - half_space.xy};
}

}  // namespace contactd

#include "influence/layered/layer_slab.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

// Beyond this depth, the material below a layer changes the compliance only by exp(-2 k h), which is negligible.
constexpr double deepest = 40;

// Returns x cosh x - sinh x, 0 <= x <= 1.
double odd_remainder(double x) {
    double term = x, sum = 0;
    for (int n = 1; n <= 9; ++n) {
        term *= x * x / ((2 * n) * (2 * n + 1));
        sum += 2 * n * term;
    }
    return sum;
}

template <std::size_t n>
std::array<double, n * n> product(const std::array<double, n * n>& left, const std::array<double, n * n>& right) {
    std::array<double, n * n> result{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t j = 0; j < n; ++j) result[n * i + j] += left[n * i + k] * right[n * k + j];
    return result;
}

}  // namespace

WaveSurface WaveSurface::half_space(double nu) {
    return {{1 - nu, (1 - 2 * nu) / 2, (1 - 2 * nu) / 2, 1 - nu}, 1};
}

Matrix4 wave_generator(double nu) {
    const double m = nu / (1 - nu), e = (1 - 2 * nu) / (2 * (1 - nu));
    return {0, 1, 1, 0, -m, 0, 0, e, 2 / (1 - nu), 0, 0, m, 0, 0, -1, 0};
}

LayerSlab::LayerSlab(const Layer& layer, double contrast)
    : thickness_(layer.thickness),
      contrast_(contrast),
      deep_(WaveSurface::half_space(layer.nu)),
      A_(wave_generator(layer.nu)),
      N_(product<4>(A_, A_)) {
    for (std::size_t i = 0; i < 4; ++i) N_[5 * i] -= 1;
    AN_ = product<4>(A_, N_);
}

void LayerSlab::raise(double k, WaveSurface& surface, WaveTransmission* down) const {
    const double depth = k * thickness_;
    if (depth > deepest) {
        surface = deep_;
        if (down != nullptr) *down = {{}, 0};
        return;
    }
    for (double& entry : surface.plane) entry *= contrast_;
    surface.across *= contrast_;
    const double across = std::tanh(depth);
    if (down != nullptr) down->across /= std::cosh(depth) * (1 + surface.across * across);
    surface.across = (surface.across + across) / (1 + surface.across * across);

    // (A^2 - 1)^2 = 0, so that exp(A x) has four terms; slices of depth up to 1 keep them similar in size.
    const int slices = std::max(1, static_cast<int>(std::ceil(depth)));
    const double x = depth / slices, cosh = std::cosh(x), sinh = std::sinh(x), odd = odd_remainder(x) / 2;
    Matrix4 P;
    for (std::size_t i = 0; i < P.size(); ++i) P[i] = sinh * A_[i] + x * sinh / 2 * N_[i] + odd * AN_[i];
    for (std::size_t i = 0; i < 4; ++i) P[5 * i] += cosh;
    for (int slice = 0; slice < slices; ++slice) {
        const Matrix2 C = surface.plane;
        const auto rows = [&](std::size_t i) {  // rows of the displacements, or of the tractions
            return Matrix2{P[4 * i] * C[0] + P[4 * i + 1] * C[2] + P[4 * i + 2],
                           P[4 * i] * C[1] + P[4 * i + 1] * C[3] + P[4 * i + 3],
                           P[4 * i + 4] * C[0] + P[4 * i + 5] * C[2] + P[4 * i + 6],
                           P[4 * i + 4] * C[1] + P[4 * i + 5] * C[3] + P[4 * i + 7]};
        };
        const Matrix2 u = rows(0), t = rows(2);
        const double scale = 1 / (t[0] * t[3] - t[1] * t[2]);
        const Matrix2 below{t[3] * scale, -t[1] * scale, -t[2] * scale,
                            t[0] * scale};  // tractions below for those above
        surface.plane = {(u[0] * t[3] - u[1] * t[2]) * scale, (u[1] * t[0] - u[0] * t[1]) * scale,
                         (u[2] * t[3] - u[3] * t[2]) * scale, (u[3] * t[0] - u[2] * t[1]) * scale};
        if (down != nullptr) down->plane = product<2>(down->plane, below);
    }
}

}  // namespace contactd

#include "influence/layered/wave_compliance.hpp"

#include <cmath>

namespace contactd {
namespace {

// Beyond it what lies below a layer is not felt: it would change the compliance by exp(-2 k h).
constexpr double deepest = 40;

// x cosh x - sinh x, 0 <= x <= 1.
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

LayeredWaves::LayeredWaves(const Layers& body) {
    double below = body.base.G;  // infinite of a rigid base
    for (std::size_t i = body.layers.size(); i-- > 0;) {
        slabs_.emplace_back(body.layers[i], body.layers[i].G / below);
        below = body.layers[i].G;
    }
    if (!body.base.is_rigid()) base_ = {half_space(body.base.nu), 1};
}

LayeredWaves::Matrix2 LayeredWaves::half_space(double nu) {
    return {1 - nu, (1 - 2 * nu) / 2, (1 - 2 * nu) / 2, 1 - nu};
}

// With u_x = U sin kx, u_z = W cos kx and G k times the tractions sin kx, cos kx, the derivatives of (U, W, t_x, t_z)
// with respect to k z. Nothing becomes infinite at nu = 1/2.
LayeredWaves::Slab::Slab(const Layer& layer, double contrast_)
    : thickness(layer.thickness), contrast(contrast_), deep(half_space(layer.nu)) {
    const double nu = layer.nu, m = nu / (1 - nu), e = (1 - 2 * nu) / (2 * (1 - nu));
    A = {0, 1, 1, 0, -m, 0, 0, e, 2 / (1 - nu), 0, 0, m, 0, 0, -1, 0};
    N = product<4>(A, A);
    for (std::size_t i = 0; i < 4; ++i) N[5 * i] -= 1;
    AN = product<4>(A, N);
}

void LayeredWaves::Slab::raise(double k, Surface& surface) const {
    const double depth = k * thickness;
    if (depth > deepest) {
        surface = {deep, 1};
        return;
    }
    for (double& entry : surface.plane) entry *= contrast;
    surface.across *= contrast;
    const double across = std::tanh(depth);
    surface.across = (surface.across + across) / (1 + surface.across * across);

    // (A^2 - 1)^2 = 0, so that exp(A x) has four terms; slices as deep as 1 keep them of one size.
    const int slices = std::max(1, static_cast<int>(std::ceil(depth)));
    const double x = depth / slices, cosh = std::cosh(x), sinh = std::sinh(x), odd = odd_remainder(x) / 2;
    Matrix4 P;
    for (std::size_t i = 0; i < P.size(); ++i) P[i] = sinh * A[i] + x * sinh / 2 * N[i] + odd * AN[i];
    for (std::size_t i = 0; i < 4; ++i) P[5 * i] += cosh;
    for (int slice = 0; slice < slices; ++slice) {
        const Matrix2 C = surface.plane;
        const auto rows = [&](std::size_t i) {  // of the displacements, or of the tractions
            return Matrix2{P[4 * i] * C[0] + P[4 * i + 1] * C[2] + P[4 * i + 2],
                           P[4 * i] * C[1] + P[4 * i + 1] * C[3] + P[4 * i + 3],
                           P[4 * i + 4] * C[0] + P[4 * i + 5] * C[2] + P[4 * i + 6],
                           P[4 * i + 4] * C[1] + P[4 * i + 5] * C[3] + P[4 * i + 7]};
        };
        const Matrix2 u = rows(0), t = rows(2);
        const double scale = 1 / (t[0] * t[3] - t[1] * t[2]);
        surface.plane = {(u[0] * t[3] - u[1] * t[2]) * scale, (u[1] * t[0] - u[0] * t[1]) * scale,
                         (u[2] * t[3] - u[3] * t[2]) * scale, (u[3] * t[0] - u[2] * t[1]) * scale};
    }
}

WaveCompliance LayeredWaves::at(double k) const {
    Surface surface = base_;
    for (const Slab& slab : slabs_) slab.raise(k, surface);
    return {surface.plane[0], (surface.plane[1] + surface.plane[2]) / 2, surface.plane[3], surface.across};
}

}  // namespace contactd

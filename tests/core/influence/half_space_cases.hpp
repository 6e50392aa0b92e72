// Provides the kernels of the half-space, and specs of closed-form tables, for tests.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd::test {

inline constexpr std::array axes = {Axis::x, Axis::y, Axis::z};

/// Returns the displacement along i at (x, y) for a unit point load along j at the origin (Johnson, chapter 3), times
/// G.
inline double kernel(Axis i, Axis j, double x, double y, double nu) {
    using std::numbers::pi;
    const double rho = std::hypot(x, y);
    const std::array<double, 3> r = {x, y, 0};
    const double ri = r[static_cast<std::size_t>(i)], rj = r[static_cast<std::size_t>(j)];
    if (i == Axis::z && j == Axis::z) return (1 - nu) / (2 * pi * rho);
    if (i == Axis::z) return -(1 - 2 * nu) / (4 * pi) * rj / (rho * rho);
    if (j == Axis::z) return (1 - 2 * nu) / (4 * pi) * ri / (rho * rho);
    return ((i == j ? (1 - nu) / rho : 0) + nu * ri * rj / (rho * rho * rho)) / (2 * pi);
}

inline IcSpec analytic(const Material& material, double dx, double dy, int nx, int ny,
                       LoadShape load_shape = LoadShape::constant) {
    IcSpec spec;
    spec.material = material;
    spec.dx = dx;
    spec.dy = dy;
    spec.nx = nx;
    spec.ny = ny;
    spec.load_shape = load_shape;
    return spec;
}

}  // namespace contactd::test

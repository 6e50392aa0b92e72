// Computes stresses below point forces on the half-space, for tests (Johnson, Contact Mechanics, (3.19) and (3.76)).
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "contactd/ic_table.hpp"

namespace contactd::test {

/// Returns xx, yy, zz, xy, xz, yz at (x, y) and depth d below a unit force along an axis of the body z <= 0.
inline std::array<double, 6> point_stress(Axis load, double x, double y, double d, double nu) {
    if (load == Axis::y) {
        auto s = point_stress(Axis::x, y, x, d, nu);
        std::swap(s[0], s[1]);
        std::swap(s[4], s[5]);
        return s;
    }
    const double R = std::hypot(x, y, d), R3 = R * R * R, R5 = R3 * R * R, rest = 1 - 2 * nu, c = R + d;
    const double unit = 0.5 / std::numbers::pi;
    std::array<double, 6> s{};
    if (load == Axis::z) {  // uses Boussinesq with pressure 1 along the depth; a unit force along z is its opposite
        const double r2 = x * x + y * y;
        s = {rest / r2 * ((1 - d / R) * (x * x - y * y) / r2 + d * y * y / R3) - 3 * d * x * x / R5,
             rest / r2 * ((1 - d / R) * (y * y - x * x) / r2 + d * x * x / R3) - 3 * d * y * y / R5,
             -3 * d * d * d / R5,
             rest / r2 * ((1 - d / R) * x * y / r2 * 2 - x * y * d / R3) - 3 * x * y * d / R5,
             -3 * x * d * d / R5,
             -3 * y * d * d / R5};
        for (double& value : s) value = -value;
    } else {  // Cerruti
        const double c2 = c * c, c3 = c2 * c;
        s = {
            -3 * x * x * x / R5 +
                rest * (x / R3 - 3 * x / (R * c2) + x * x * x / (R3 * c2) + 2 * x * x * x / (R * R * c3)),
            -3 * x * y * y / R5 + rest * (x / R3 - x / (R * c2) + x * y * y / (R3 * c2) + 2 * x * y * y / (R * R * c3)),
            -3 * x * d * d / R5,
            -3 * x * x * y / R5 + rest * (-y / (R * c2) + x * x * y / (R3 * c2) + 2 * x * x * y / (R * R * c3)),
            -3 * x * x * d / R5,
            -3 * x * y * d / R5};
    }
    for (double& value : s) value *= unit;
    s[4] = -s[4];  // the depth runs against z
    s[5] = -s[5];
    return s;
}

}  // namespace contactd::test

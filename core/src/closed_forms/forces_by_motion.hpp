// Defines derivatives of tangential forces with respect to the motion, for the simplified models.
#pragma once

#include <array>

#include "rolling_frame.hpp"

namespace contactd {

/// Holds the derivatives of Fx, Fy and Mz with respect to the motion along x, along y and about z.
using ForcesByMotion = std::array<std::array<double, 3>, 3>;

/// Moves a motion away from zero, where a derivative exists but cannot be computed; it is evaluated right beside.
inline std::array<double, 2> away_from_zero(const std::array<double, 2>& w, double scale) {
    return w[0] == 0 && w[1] == 0 ? std::array{1e-12 * scale, 0.0} : w;
}

/// Converts derivatives from the frame of rolling: forces and motion rotate with it.
inline ForcesByMotion in_coordinates(const RollingFrame& frame, const ForcesByMotion& local) {
    ForcesByMotion result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[0][k] = frame.x_of(local[0][k], local[1][k]);
        result[1][k] = frame.y_of(local[0][k], local[1][k]);
        result[2][k] = local[2][k];
    }
    for (auto& row : result) {
        const double along = row[0], across = row[1];
        row[0] = frame.x_of(along, across);
        row[1] = frame.y_of(along, across);
    }
    return result;
}

}  // namespace contactd

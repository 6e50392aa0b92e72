// The slip of a shift.
#pragma once

#include <span>
#include <vector>

#include "contactd/influence_operator.hpp"

namespace contactd {

/// Slip of the upper body over the lower one, per element, zero outside contact (mm).
struct SlipDistance {
    std::vector<double> x, y;
};

/// s = A_t p + w where `bound` is positive. Arrays as solve_tangential has them; costs one tangential product.
SlipDistance slip_distance(const InfluenceOperator& influence, std::span<const double> bound,
                           std::span<const double> rigid_x, std::span<const double> rigid_y,
                           std::span<const double> traction_x, std::span<const double> traction_y);

}  // namespace contactd

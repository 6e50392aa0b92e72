// Computes the slip of a shift.
#pragma once

#include <span>
#include <vector>

#include "contactd/influence_operator.hpp"

namespace contactd {

/// Holds the slip of the upper body over the lower one, per element, zero outside the contact (mm).
struct SlipDistance {
    std::vector<double> x, y;
};

/// Returns s = A_t p + w where `bound` is positive. Arrays are those of solve_tangential. It costs one tangential
/// product.
SlipDistance slip_distance(const InfluenceOperator& influence, std::span<const double> bound,
                           std::span<const double> rigid_x, std::span<const double> rigid_y,
                           std::span<const double> traction_x, std::span<const double> traction_y);

}  // namespace contactd

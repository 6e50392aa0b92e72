// Finds branches of the force over the height. If patches merge, the force decreases, and several heights produce the
// same force.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Returns the number of regions of overlap in all patches.
std::size_t regions_in(const WheelRailSolution& solution);

/// Searches for the height nearest to `z` that is on another branch, between `z` and `end` (mm). Returns the border to
/// 1e-7 mm, or nothing.
std::optional<double> nearest_height(const std::function<bool(double z)>& is_on_branch, double z, double end);

}  // namespace contactd

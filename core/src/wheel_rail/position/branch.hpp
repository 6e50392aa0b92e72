// Branches of the force over the height: where patches merge it falls, and several heights bring one force.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Returns the regions of overlap in all patches.
std::size_t regions_in(const WheelRailSolution& solution);

/// Looks for the height nearest to `z` that is on another branch, from there on as far as `end` (mm); nothing where
/// there is none. The answer is on the border, to 1e-7 mm.
std::optional<double> nearest_height(const std::function<bool(double z)>& is_on_branch, double z, double end);

}  // namespace contactd

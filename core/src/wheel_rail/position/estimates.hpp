// Tractions of a patch as those of the step before let expect them.
#pragma once

#include <vector>

#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Those of the patch that was nearest, moved with the reference by whole elements; empty where there was none of the
/// same elements.
SurfaceState estimate_for(const ContactPlace& place, const std::vector<WheelRailEstimates::Patch>& before);

/// Returns the estimates of patches of model full.
std::vector<WheelRailEstimates::Patch> estimates_of(const WheelRailSolution& solution);

}  // namespace contactd

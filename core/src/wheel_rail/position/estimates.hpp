// Tractions of a patch as those of the step before let expect them.
#pragma once

#include <vector>

#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Those of the patch that was nearest, moved with the reference by whole elements; empty where there was none of the
/// same elements.
SurfaceState estimate_for(const ContactPlace& place, const std::vector<WheelRailEstimates::Patch>& before);

/// Returns that of a patch of model full, of a step with this position.x.
WheelRailEstimates::Patch estimate_of(const geometry::CandidatePatch& found, double x, const ContactSolution& solution);

}  // namespace contactd

// Estimates the tractions of a patch from the previous step.
#pragma once

#include <vector>

#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Returns the tractions of the nearest previous patch, moved with the reference by whole elements, or none if no patch
/// had the same elements.
SurfaceState estimate_for(const ContactPlace& place, const std::vector<WheelRailEstimates::Patch>& before);

/// Returns the estimate from a patch of model full, of a step with this position.x.
WheelRailEstimates::Patch estimate_of(const geometry::CandidatePatch& found, double x, const ContactSolution& solution);

}  // namespace contactd

// Warns about wheels that do not run on their treads.
#pragma once

#include <optional>
#include <string>

#include "contactd/wheel_rail_solution.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Returns a warning about a right wheel that climbs on its flange, with its tread lifted off the rail, or that rolls
/// on the end of its tread. It contains Fy/Fz and the lift of the tread. `wheel` is its solved position.
std::optional<std::string> off_tread_warning(const WheelRailSolution& solution, const geometry::Profiles& profiles,
                                             const geometry::WheelSurface& wheel, const geometry::RailSurface& rail);

}  // namespace contactd

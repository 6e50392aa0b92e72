// Wheels that do not run on their treads.
#pragma once

#include <optional>
#include <string>

#include "contactd/wheel_rail_solution.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// A sentence about a right wheel that climbs on its flange, its tread lifted off the rail, or that rolls on the end of
/// its tread: with Fy/Fz, and by how much its tread is lifted. `wheel` is where it was solved.
std::optional<std::string> off_tread_warning(const WheelRailSolution& solution, const geometry::Profiles& profiles,
                                             const geometry::WheelSurface& wheel, const geometry::RailSurface& rail);

}  // namespace contactd

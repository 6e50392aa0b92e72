// What the motion of a wheelset means at one of its contacts: rigid-body kinematics.
#pragma once

#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Taken at the reference: that of the rail, and of the wheel by `approach` deeper. The rolling velocity is the mean of
/// the speeds of the wheel over the ground and of its rim about the axle, or of rim and roller; creepages are zero
/// where it is.
Creepages creepages(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                    const ContactReference& reference, double approach);

}  // namespace contactd::geometry

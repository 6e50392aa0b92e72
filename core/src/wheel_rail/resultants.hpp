// Forces of a patch in all coordinates that somebody wants them in.
#pragma once

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/distance/heights.hpp"
#include "geometry/placement/vector3.hpp"

namespace contactd {

/// Slopes of the rail along the track, and which forces follow them.
struct FollowedSlopes {
    const geometry::SlopesAlong& slopes;
    SlopeForces forces;
};

/// `rail` and `wheelset` are their axes in the track. Of simplified models the pressures' centre is the reference.
/// Tractions of a curved contact are turned row by row.
WheelRailForces resultants(const ContactPlace& place, const ContactSolution& solution, bool simplified,
                           const FollowedSlopes& followed, const geometry::Frame& rail,
                           const geometry::Frame& wheelset);

WheelRailForces sum(const WheelRailForces& a, const WheelRailForces& b);

}  // namespace contactd

// Computes the forces of a patch in all coordinate systems of the answer.
#pragma once

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/distance/heights.hpp"
#include "geometry/placement/vector3.hpp"

namespace contactd {

/// Holds slopes of the rail along the track, and selects the forces that depend on them.
struct FollowedSlopes {
    const geometry::SlopesAlong& slopes;
    SlopeForces forces;
};

/// Returns the forces of a patch. `rail` and `wheelset` are their axes in the track. For simplified models, the
/// reference is the centre of pressure. Tractions of a curved contact are rotated row by row.
WheelRailForces resultants(const ContactPlace& place, const ContactSolution& solution, bool simplified,
                           const FollowedSlopes& followed, const geometry::Frame& rail,
                           const geometry::Frame& wheelset);

WheelRailForces sum(const WheelRailForces& a, const WheelRailForces& b);

}  // namespace contactd

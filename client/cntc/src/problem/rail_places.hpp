// Where a wheel on a rail and its patches lie, and what forces act there, in all axes that the interface has.
#pragma once

#include <array>

#include "geometry/placement/vector3.hpp"
#include "problem/rail_case.hpp"

namespace contactd::cntc {

/// Axes of a right wheel and its rail in the track; those of left ones are seen in a mirror.
struct RailFrames {
    double side = 1;                        ///< of y and all that turns about x or z: -1 in the mirror
    geometry::Frame wheelset, wheel, rail;  ///< origins of the latter two are those of the profiles
    double roll_of_rail = 0;
};

/// By the last solve, or else by what is set.
RailFrames frames_of(RailCase& rail, const Settings& common);

/// The answer of cntc_getcontactlocation, in mm and rad; numbers 1 to 38 at 0 to 37.
std::array<double, 38> location_of(const WheelRailPatch& patch, RailCase& rail, const Settings& common);

/// The answer of cntc_getglobalforces, in N and N mm, on the rail: six numbers each in the axes of track, wheelset,
/// rail and wheel; moments about the rail's profile in those of track and rail, and about the wheel's in the others.
std::array<double, 24> wrenches_of(const WheelRailForces& forces, RailCase& rail, const Settings& common);

}  // namespace contactd::cntc

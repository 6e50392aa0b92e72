// Where a wheel on a rail and its patches lie, and what forces act there, in the axes that CONTACT prints.
#pragma once

#include <array>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/vector3.hpp"
#include "geometry/position.hpp"

namespace contactd::cases {

/// The curves of wheel and rail, and the set-up that places them.
struct RailOutlines {
    WheelRailSetup setup;  ///< without friction
    geometry::Profiles profiles;
};

/// Axes of a right wheel and its rail in the track; those of left ones are seen in a mirror.
struct RailFrames {
    double side = 1;                        ///< of y and all that turns about x or z: -1 in the mirror
    geometry::Frame wheelset, wheel, rail;  ///< origins of the latter two are those of the profiles
    double roll_of_rail = 0;
};

/// Where wheel and rail lie in a state, which is that of either side.
RailFrames frames_of(const RailOutlines& outlines, const WheelRailState& state);
/// The state with the height and the deflection that its solve has found.
WheelRailState found_state(WheelRailState state, const WheelRailSolution& solution);

/// The place of a patch, in mm and rad: the numbers 1 to 38 of cntc_getcontactlocation at 0 to 37, without those of the
/// deflection of the rail.
std::array<double, 38> location_of(const WheelRailPatch& patch, const RailOutlines& outlines, const RailFrames& frames);

/// Forces in N and N mm on the rail: six numbers each in the axes of track, wheelset, rail and wheel; moments about the
/// rail's profile in those of track and rail, and about the wheel's in the others.
std::array<double, 24> wrenches_of(const WheelRailForces& forces, const RailFrames& frames);

}  // namespace contactd::cases

// Computes positions of a wheel, its rail and its patches, and the forces, in the axes that CONTACT prints.
#pragma once

#include <array>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/vector3.hpp"
#include "geometry/position.hpp"

namespace contactd::cases {

/// Holds the profile curves of wheel and rail, and their set-up.
struct RailOutlines {
    WheelRailSetup setup;  ///< without friction
    geometry::Profiles profiles;
};

/// Axes of a right wheel and its rail in track coordinates. For a left wheel they are those of the mirror image.
struct RailFrames {
    double side = 1;                        ///< sign of y and of rotations about x and z: -1 in the mirror image
    geometry::Frame wheelset, wheel, rail;  ///< the origins of the last two are those of the profiles
    double roll_of_rail = 0;
};

/// Returns the frames of wheel and rail in a state of a left or right wheel.
RailFrames frames_of(const RailOutlines& outlines, const WheelRailState& state);
/// Returns the state with the height and the rail deflection found by its solve.
WheelRailState found_state(WheelRailState state, const WheelRailSolution& solution);

/// Returns the location of a patch in mm and rad: the numbers 1 to 38 of cntc_getcontactlocation at the indices 0 to
/// 37, without those of the rail deflection.
std::array<double, 38> location_of(const WheelRailPatch& patch, const RailOutlines& outlines, const RailFrames& frames);

/// Returns forces and moments on the rail (N, N mm): six numbers each in the axes of track, wheelset, rail and wheel.
/// Moments are about the origin of the rail's profile in the axes of track and rail, and of the wheel's in the others.
std::array<double, 24> wrenches_of(const WheelRailForces& forces, const RailFrames& frames);

}  // namespace contactd::cases

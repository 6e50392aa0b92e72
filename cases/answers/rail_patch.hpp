// A patch of a wheel on a rail as a contact problem, whose answers are those of basic contact.
#pragma once

#include "answers/solved.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::cases {

/// Makes the contact problem of a patch with its solution; arrays of `solved` are used again. Elements of a step that
/// is not steady are counted from the place where the rail's profile begins, and so is its motion. Returns the motion
/// of the reference.
Motion show_patch(const WheelRailPatch& patch, const WheelRailSetup& setup, const WheelRailState& state,
                  Solved& solved);

}  // namespace contactd::cases

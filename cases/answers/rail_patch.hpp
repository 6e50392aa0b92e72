// Converts a patch of a wheel on a rail to a contact problem, so that results are those of basic contact.
#pragma once

#include "answers/solved.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::cases {

/// Stores the contact problem and the solution of a patch in `solved`, and reuses its arrays. In a step that is not
/// steady, elements and motion are relative to the origin of the rail's profile. Returns the motion of the reference.
Motion show_patch(const WheelRailPatch& patch, const WheelRailSetup& setup, const WheelRailState& state,
                  Solved& solved);

}  // namespace contactd::cases

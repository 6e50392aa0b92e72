// Converts a patch of a wheel on a rail to a contact problem, so that results are those of basic contact.
#pragma once

#include "answers/solved.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::cases {

/// Returns the reference of a patch relative to the origin from which the elements of a step that is not steady are
/// counted, in the axes of the patch (mm): along the track, from the wheelset in transient rolling, and across the
/// rail.
RailPlace counted_from(const ContactPlace& place, const WheelRailState& state);

/// Stores the contact problem and the solution of a patch in `solved`, and reuses its arrays. In a step that is not
/// steady, elements and motion are relative to the origin of the rail's profile. Returns the motion of the reference.
Motion show_patch(const WheelRailPatch& patch, const WheelRailSetup& setup, const WheelRailState& state,
                  Solved& solved);

}  // namespace contactd::cases

// A rail without mass on springs: it gives way until wheel, springs and what else acts on it are in balance.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

class RightWheel;

/// What a right wheel answers to its height or force, the pitch rate as it is. To the side the shift is found by
/// secants. Downwards it follows from a prescribed force; else it is searched for within each step of these, as the
/// height that brings a force. Starts from `estimates`, and leaves those for the next step.
WheelRailSolution solve_on_springs(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer);

/// Sets the derivatives of such a solution, to which the rail gives way, or says in a warning why there are none.
void differentiate_on_springs(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer);

/// The set-up of the same rail held where it is.
WheelRailSetup held(WheelRailSetup setup);
/// The state with the rail where it is expected without a solve, and held there: to the side as the forces beside the
/// wheel's have it, downwards also by the wheel's force.
WheelRailState expected_on_springs(const RightWheel& wheel);

}  // namespace contactd

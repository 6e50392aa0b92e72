// Solves the force balance: the pitch rate for a prescribed Fx, and the deflection of a massless flexible rail.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

class RightWheel;

/// Solves a right wheel under its height or force. Pitch rate and lateral deflection are found together; the vertical
/// deflection follows from a prescribed force, or is searched within each of their steps, like the height for a
/// prescribed force. Starts from `estimates`, and updates them for the next step.
WheelRailSolution solve_in_balance(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer);

}  // namespace contactd

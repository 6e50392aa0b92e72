// Forces in balance: the pitch rate that brings Fx, and the deflection of a massless flexible rail.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

class RightWheel;

/// Solves a right wheel under its height or force. Pitch rate and lateral deflection are found together; the vertical
/// deflection follows from a prescribed force, or is searched for within each of their steps, as the height that brings
/// a force. Starts from `estimates`, and leaves those for the next step.
WheelRailSolution solve_in_balance(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer);

}  // namespace contactd

// A massless flexible rail: it deflects until wheel, springs and what else acts on it are in balance.
#pragma once

#include <string>

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

class RightWheel;

inline constexpr double deepest_penetration = 5;  ///< of a wheel in its rail (mm): deeper than anything elastic

/// Solves a right wheel under its height or force, the pitch rate as it is. Secants find the lateral deflection. The
/// vertical one follows from a prescribed force; else it is searched for within each step of these, as the height that
/// brings a force. Starts from `estimates`, and leaves those for the next step.
WheelRailSolution solve_on_flexible_rail(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer);

/// Sets the derivatives of such a solution, in which the rail deflects, or says in a warning why there are none.
void differentiate_on_flexible_rail(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer);

/// Throws InvalidArgument for a force below `name` on a rail that is rigid in its direction.
void check_rail_loads(const WheelRailSetup& setup, const RailDeviation& rail, const std::string& name);

/// Returns the set-up with the rail fixed where it is.
WheelRailSetup with_fixed_rail(WheelRailSetup setup);
/// Returns the state with the rail fixed where it is expected without a solve: laterally by the forces besides the
/// wheel's, vertically also by the wheel's force.
WheelRailState expected_on_flexible_rail(const RightWheel& wheel);

}  // namespace contactd

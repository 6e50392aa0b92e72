// Computes derivatives of the pressures of a wheel's patches.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

class RightWheel;

/// Returns whether the motion affects the forces only through the creepages of the contacts, with a friction law whose
/// derivatives are available.
bool acts_through_creepages(const WheelRailSetup& setup, const WheelRailState& state);

/// Sets ContactSolution::pressure_by_approach of the patches of a converged solution: its derivative by the approach of
/// the patch, along its normal. It is not available for simplified models, curved patches and viscoelastic bodies. If
/// pressures depend on the friction, it requires acts_through_creepages.
void differentiate_pressures(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer);

}  // namespace contactd

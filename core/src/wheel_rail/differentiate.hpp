// Computes derivatives of the forces of a wheel with respect to its position and its motion.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

class RightWheel;

/// Sets the derivatives of the wheel's solution and of the pressures of its patches, or adds a warning if there are
/// none. Derivatives by the motion are those of the contact, with frozen element division, by the creepages.
/// Derivatives by the position, and those that the contact does not provide, are central differences of solves with
/// tighter tolerances.
void differentiate(RightWheel& wheel, WheelRailSolution& solution, Observer& observer);

}  // namespace contactd

// How the forces of a wheel follow its position and its motion.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

class RightWheel;

/// Sets the derivatives of the wheel's solution, or says in a warning why there are none. By the motion they are those
/// of the contact, its element division frozen, through the creepages; by the position, and where the contact's are not
/// known, they are central differences of solves with finer tolerances.
void differentiate(RightWheel& wheel, WheelRailSolution& solution, Observer& observer);

}  // namespace contactd

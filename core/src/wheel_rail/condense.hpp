// Computes derivatives of forces on a massless flexible rail.
#pragma once

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Converts derivatives of the forces on a fixed rail (in track coordinates, as their sum `forces`) to those on a
/// flexible one. A rail that moves laterally with its wheel has the same forces, about another point. The effect of its
/// deflection therefore follows from that of the wheel's position, and the deflection from the balance of the springs.
void condense_rail_deflection(WheelRailDerivatives& derivatives, const Wrench& forces, const RailSprings& springs);

}  // namespace contactd

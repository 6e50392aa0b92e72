// Derivatives of forces on a rail that gives way to them.
#pragma once

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Turns derivatives of the forces on a rail that is held (in track coordinates, as their sum `forces`) into those on a
/// rail on springs. A rail that goes aside with its wheel has the same forces, about another point: so what its shift
/// does follows from what the wheel's position does, and the balance of the springs gives the shift.
void let_give_way(WheelRailDerivatives& derivatives, const Wrench& forces, const RailSprings& springs);

}  // namespace contactd

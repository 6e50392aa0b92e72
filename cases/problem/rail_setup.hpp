// From what a program has set to a set-up and a state of a wheel on its rail.
#pragma once

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "given/given.hpp"
#include "given/given_rail.hpp"

namespace contactd::cases {

bool on_roller(const Given& settings);
bool on_left_side(const Given& settings);

/// Returns what says where wheel and rail lie: their profiles, as far as they are set, track and wheelset.
WheelRailSetup outline_of(const Given& settings, const GivenRail& rail);
/// Position and motion, without the forces that bring them.
WheelRailState placed_state(const Given& settings, const GivenRail& rail);

/// Both throw NotCovered for what is missing, contradicts itself, or is not covered.
WheelRailSetup setup_of(const Given& settings, const GivenRail& rail);
WheelRailState state_of(const Given& settings, const GivenRail& rail);

}  // namespace contactd::cases

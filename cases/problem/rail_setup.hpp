// Converts the values of a case to a set-up and a state of a wheel on its rail.
#pragma once

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "given/given.hpp"
#include "given/given_rail.hpp"

namespace contactd::cases {

bool on_roller(const Given& settings);
bool on_left_side(const Given& settings);

/// Returns a set-up with the geometry only: the given profiles, track and wheelset.
WheelRailSetup outline_of(const Given& settings, const GivenRail& rail);
/// Returns a state with position and motion, without prescribed forces.
WheelRailState placed_state(const Given& settings, const GivenRail& rail);

/// Return the complete set-up and state. Both throw NotCovered for missing, inconsistent and unsupported values.
WheelRailSetup setup_of(const Given& settings, const GivenRail& rail);
WheelRailState state_of(const Given& settings, const GivenRail& rail);

}  // namespace contactd::cases

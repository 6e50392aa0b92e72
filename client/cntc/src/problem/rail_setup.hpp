// From what a program has set to a set-up and a state of a wheel on its rail.
#pragma once

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "problem/rail_settings.hpp"
#include "problem/settings.hpp"

namespace contactd::cntc {

bool on_roller(const Settings& settings);
bool on_left_side(const Settings& settings);

/// Returns what says where wheel and rail lie: their profiles, as far as they are set, track and wheelset.
WheelRailSetup outline_of(const Settings& settings, const RailSettings& rail);
/// Position and motion, without the forces that bring them.
WheelRailState placed_state(const Settings& settings, const RailSettings& rail);

/// Both throw Refused for what is missing, contradicts itself, or is not covered.
WheelRailSetup setup_of(const Settings& settings, const RailSettings& rail);
WheelRailState state_of(const Settings& settings, const RailSettings& rail);

}  // namespace contactd::cntc

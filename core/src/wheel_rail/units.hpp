// Likely mistakes of units in wheels on rails, whose units are N, mm, s and rad.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

/// Sentences about moduli that neither wheels nor rails have.
std::vector<std::string> unit_warnings(const WheelRailSetup& setup);

/// Sentences about a load that is next to none.
std::vector<std::string> unit_warnings(const WheelRailSetup& setup, const WheelRailState& state);

/// A sentence about a wheelset that is off the middle by some micrometres, as if that were metres. Runs of a vehicle
/// come by such positions; single states hardly do.
std::vector<std::string> position_warnings(const WheelRailState& state);

/// Tells sentences about fields of a patch's contact problem that the wheel makes itself, and has its own sentences of.
bool names_inputs_of_patches(std::string_view warning);

}  // namespace contactd

// Probable mistakes of units in wheel-rail contact, whose units are N, mm, s and rad.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

/// Sentences about moduli and coefficients of friction that neither wheels nor rails have, and about slices that are
/// closer together than contacts are long.
std::vector<std::string> unit_warnings(const WheelRailSetup& setup);

/// Sentences about angles that look as if they were in degrees, a load that is next to none, and a wheel that is a
/// thousand times as far along the track as the slices of its rail.
std::vector<std::string> unit_warnings(const WheelRailSetup& setup, const WheelRailState& state);

/// Sentences about a wheelset that is off the middle by some micrometres, as if that were metres, and about one that
/// rolls as slowly as if its speed were in m/s or km/h. Runs of a vehicle come by such states; single ones hardly do.
std::vector<std::string> unit_warnings_of_one(const WheelRailSetup& setup, const WheelRailState& state);

/// Returns what a wheel that slides by most of its velocity has in another unit, as far as its speed and its pitch rate
/// tell that; else nothing.
std::string unit_of_speed(const WheelRailSetup& setup, const WheelRailState& state);

/// Returns whether a warning is about fields of a patch's contact problem that the wheel sets itself and has its own
/// warnings for.
bool names_inputs_of_patches(std::string_view warning);

}  // namespace contactd

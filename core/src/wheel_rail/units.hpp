// Warns of probable mistakes of units in wheel-rail contact, whose units are N, mm, s and rad.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

/// Returns sentences about moduli and coefficients of friction that are unusual for wheels and rails, and about slices
/// that are closer together than the length of a contact.
std::vector<std::string> unit_warnings(const WheelRailSetup& setup);

/// Returns sentences about angles that are probably in degrees, a nearly zero load, and a wheel that is a thousand
/// times as far along the track as the slices of its rail.
std::vector<std::string> unit_warnings(const WheelRailSetup& setup, const WheelRailState& state);

/// Returns sentences about a wheelset that is off the centre by some micrometres, which are probably metres, and about
/// one whose low speed is probably in m/s or km/h. Such states occur in simulations of a vehicle, but hardly in single
/// solves.
std::vector<std::string> unit_warnings_of_one(const WheelRailSetup& setup, const WheelRailState& state);

/// Returns the input of a wheel that is probably in another unit if the wheel slides by most of its velocity, as far as
/// its speed and its pitch rate show this. Otherwise returns an empty string.
std::string unit_of_speed(const WheelRailSetup& setup, const WheelRailState& state);

/// Returns whether a warning is about fields of a patch's contact problem that the wheel sets itself. The wheel has its
/// own warnings for these.
bool names_inputs_of_patches(std::string_view warning);

}  // namespace contactd

// Finds the least vertical gap between a wheel and its rail, in the plane across the track.
#pragma once

#include <limits>

#include "contactd/wheelset_contacts.hpp"

namespace contactd::geometry {

struct LeastGap {
    double gap = std::numeric_limits<double>::infinity();  // mm; infinite if the wheel is not above the rail
    double wheel_s = 0, rail_s = 0;
    ProfilePoint place{};  // point of the rail, from the middle of the track outwards
    bool at_end = false;
};

/// Returns the least gap of a wheelset shifted by `shift` and rotated by `roll`, both outwards as seen from this wheel.
/// It rotates about the middle of the axle, which lies the wheel's nominal radius above the plane of the track.
LeastGap least_gap(const WheelOverRail& pair, double shift, double roll);

}  // namespace contactd::geometry

// Where the vertical gap between a wheel and its rail is least, in the plane across the track.
#pragma once

#include <limits>

#include "contactd/wheelset_contacts.hpp"

namespace contactd::geometry {

struct LeastGap {
    double gap = std::numeric_limits<double>::infinity();  // mm; infinite where the wheel is not above the rail
    double wheel_s = 0, rail_s = 0;
    ProfilePoint place{};  // of the rail, from the middle of the track outwards
    bool at_end = false;
};

/// The wheelset is shifted by `shift` and turned by `roll`, both outwards as seen from this wheel, about the middle of
/// the axle, which lies the wheel's nominal radius above the plane of the track.
LeastGap least_gap(const WheelOverRail& pair, double shift, double roll);

}  // namespace contactd::geometry

// Computes contacts of a rigid wheelset on rigid rails: contact points, angles and radii against its lateral shift.
//
// In track coordinates, y is to the right in the direction of travel, z is down, and the origin is on the plane of the
// track. Profiles have y to the field side on both sides. Lengths are in mm, angles in rad.
#pragma once

#include <optional>

#include "contactd/conicity.hpp"
#include "contactd/profile.hpp"
#include "contactd/wheel_rail_setup.hpp"

namespace contactd {

/// Describes a wheel above its rail, seen from the middle of the track outwards.
struct WheelOverRail {
    ProfileCurve wheel;
    ProfileCurve rail;
    double wheel_origin = 750;              ///< from the middle of the axle to y = 0 of the wheel's profile
    ProfilePoint rail_origin{};             ///< origin of the rail's profile, from the middle of the track
    double nominal_radius = 460;            ///< radius of the wheel at z = 0 of its profile
    std::optional<double> roller_radius{};  ///< see Track; absent: a rail
};

struct WheelsetOnTrack {
    WheelOverRail left, right;
};

/// Returns one side of a wheelset on a track. Throws InvalidArgument, which names the field, "track.gauge",
/// "wheelset.flange_back_distance", ...
WheelOverRail wheel_over_rail(const ProfileCurve& wheel, const ProfileCurve& rail, const Track& track = {},
                              const Wheelset& wheelset = {});
/// Returns a wheelset with the same profiles on both sides. Throws as wheel_over_rail.
WheelsetOnTrack wheelset_on_track(const ProfileCurve& wheel, const ProfileCurve& rail, const Track& track = {},
                                  const Wheelset& wheelset = {});

/// Returns the contacts of the wheelset shifted to the right by `shift`, without yaw. Without yaw, a wheelset touches
/// rollers at their tops, where their sections are used. If a wheel touches at two points, rounding decides which one
/// is returned. Throws InvalidArgument for shifts at which a wheel is not above its rail.
WheelsetContacts contacts_at(const WheelsetOnTrack& wheelset, double shift, WheelsetRoll roll = WheelsetRoll::demanded);

}  // namespace contactd

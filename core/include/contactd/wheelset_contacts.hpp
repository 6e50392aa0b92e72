// Contacts of a rigid wheelset on rigid rails: contact points, angles and radii against its lateral shift.
//
// Track coordinates: y to the right in the direction of travel, z down, the origin on the plane of the track. Profiles
// have y to the field side on both sides. Lengths in mm, angles in rad.
#pragma once

#include <optional>

#include "contactd/conicity.hpp"
#include "contactd/profile.hpp"
#include "contactd/wheel_rail_setup.hpp"

namespace contactd {

/// A wheel above its rail, seen from the middle of the track outwards.
struct WheelOverRail {
    ProfileCurve wheel;
    ProfileCurve rail;
    double wheel_origin = 750;              ///< from the middle of the axle to y = 0 of the wheel's profile
    ProfilePoint rail_origin{};             ///< of the rail's profile, from the middle of the track
    double nominal_radius = 460;            ///< of the wheel at z = 0 of its profile
    std::optional<double> roller_radius{};  ///< as in Track; absent: a rail
};

struct WheelsetOnTrack {
    WheelOverRail left, right;
};

/// Throws InvalidArgument naming the field, "track.gauge", "wheelset.flange_back_distance", ...
WheelOverRail wheel_over_rail(const ProfileCurve& wheel, const ProfileCurve& rail, const Track& track = {},
                              const Wheelset& wheelset = {});
/// Uses the same profiles on both sides. Throws as wheel_over_rail.
WheelsetOnTrack wheelset_on_track(const ProfileCurve& wheel, const ProfileCurve& rail, const Track& track = {},
                                  const Wheelset& wheelset = {});

/// Returns the contacts of the wheelset shifted to the right by `shift`, without yaw. Such a wheelset touches rollers
/// at their tops, where they are cut. If a wheel touches at two points, returns the one with the smaller gap by
/// rounding. Throws InvalidArgument for shifts at which a wheel is not above its rail.
WheelsetContacts contacts_at(const WheelsetOnTrack& wheelset, double shift, WheelsetRoll roll = WheelsetRoll::demanded);

}  // namespace contactd

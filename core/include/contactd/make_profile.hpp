// Creates the curve of a profile.
#pragma once

#include "contactd/profile.hpp"
#include "contactd/profile_evidence.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// Holds the curve of a wheel or a rail: y ascends, and the wheel's flange or the rail's gauge side is at y < 0.
struct Profile {
    ProfileKind kind = ProfileKind::wheel;
    ProfileCurve curve;
    ProfileEvidence evidence{};
};

/// Makes the curve of a profile. Points are mirrored, converted to mm, ordered by y and cleaned: points that coincide
/// or turn back are dropped, and zigzags are averaged. A wheel keeps the points visible from above on both sides of its
/// middle, a rail those not hidden from above. The curve is broken at kinks and smoothed. Throws InvalidArgument, which
/// names the field below "profile", for crossing or unordered points, for too few of them, and for profiles upside down
/// or mirrored.
Profile make_profile(const ProfileSpec& spec);

}  // namespace contactd

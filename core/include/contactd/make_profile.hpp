// From a profile as a value to its curve.
#pragma once

#include "contactd/profile.hpp"
#include "contactd/profile_evidence.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// The curve of a wheel or a rail: y ascends, and the wheel's flange, the rail's gauge side lie at y < 0.
struct Profile {
    ProfileKind kind = ProfileKind::wheel;
    ProfileCurve curve;
    ProfileEvidence evidence{};
};

/// Points are mirrored, brought to mm, ordered by y and cleaned: what coincides or turns back is dropped, zigzags are
/// averaged, of a wheel remains what is seen from above on both sides of its middle, of a rail what is not hidden from
/// above. The curve is broken at kinks and smoothed. Throws InvalidArgument naming the field below "profile" for points
/// that cross themselves, that are in no order, or of which too few remain, and for profiles upside down or mirrored.
Profile make_profile(const ProfileSpec& spec);

}  // namespace contactd

// Prepares given points for a curve.
#pragma once

#include "contactd/profile_spec.hpp"
#include "geometry/profile/cleaning.hpp"

namespace contactd::geometry {

/// Returns the points in mm, from the end with the lesser y to the other.
Points points_in_mm(const ProfilePoints& given);
/// Returns the points in mm, ordered from the end with the lesser y to the other, and cleaned; some may be hidden from
/// above. Throws InvalidArgument below "profile" for points that do not form a profile.
Points measured_points(const ProfilePoints& given, ProfileKind kind);

}  // namespace contactd::geometry

// Points as they were given, made ready for a curve.
#pragma once

#include "contactd/profile_spec.hpp"
#include "geometry/profile/cleaning.hpp"

namespace contactd::geometry {

/// In mm, y ascending, cleaned. Throws InvalidArgument below "profile" for points that make no profile.
Points measured_points(const ProfilePoints& given, ProfileKind kind);

}  // namespace contactd::geometry

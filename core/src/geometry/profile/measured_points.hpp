// Points as they were given, made ready for a curve.
#pragma once

#include "contactd/profile_spec.hpp"
#include "geometry/profile/cleaning.hpp"

namespace contactd::geometry {

/// In mm, from the end of lesser y to the other, cleaned; some may be hidden from above. Throws InvalidArgument below
/// "profile" for points that make no profile.
Points measured_points(const ProfilePoints& given, ProfileKind kind);

}  // namespace contactd::geometry

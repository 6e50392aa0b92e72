// Warns of likely mistakes in measured profiles.
#pragma once

#include <string>
#include <vector>

#include "contactd/make_profile.hpp"

namespace contactd::geometry {

/// Returns sentences about a profile whose points are probably in inches by its width, points that scatter or are
/// rounded so that their curvature is noise, smoothing that removes more than noise, and rails whose gauge side lies at
/// y > 0.
std::vector<std::string> profile_warnings(const Profile& profile);

/// Returns a sentence about a mirrored rail, or about all slices of one.
std::string gauge_side_warning(const std::string& name);

/// Returns a sentence about the part between two points that is hidden from above.
std::string bridge_warning(ProfileKind kind, const ProfilePoint& from, const ProfilePoint& to);

}  // namespace contactd::geometry

// Likely mistakes in profiles that were measured.
#pragma once

#include <string>
#include <vector>

#include "contactd/make_profile.hpp"

namespace contactd::geometry {

/// Sentences about a profile by points that is as wide as if they were in inches, about points that scatter or are
/// rounded so that their curvature is noise, about smoothing that takes away more than noise, and about rails whose
/// gauge side lies at y > 0.
std::vector<std::string> profile_warnings(const Profile& profile);

/// A sentence about a rail that is read in a mirror, or about all slices of one.
std::string gauge_side_warning(const std::string& name);

/// A sentence about what is hidden from above between two points.
std::string bridge_warning(ProfileKind kind, const ProfilePoint& from, const ProfilePoint& to);

}  // namespace contactd::geometry

// A profile, by its formula or by points.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/profile_spec.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

nlohmann::json encode_profile(const ProfileSpec& profile, ArrayWriter& arrays);
/// Replaces the shape; which of both bodies the profile is of stays. `field` is where it stands. Throws StatusError for
/// points that are too many or no pairs, and for ends in the wrong order.
void decode_profile(const nlohmann::json& source, ProfileSpec& profile, const Frames& frames, const std::string& field);

/// Points as an array [n, 2] of y and z.
nlohmann::json encode_pairs(const std::vector<ProfilePoint>& points, ArrayWriter& arrays);
/// Throws StatusError naming `field` for points that are too many or no pairs.
std::vector<ProfilePoint> decode_pairs(const nlohmann::json& source, const Frames& frames, const std::string& field);

}  // namespace contactd::proto

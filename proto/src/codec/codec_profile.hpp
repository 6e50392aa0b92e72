// Encodes and decodes a profile, given by a formula or by points.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/profile_spec.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

nlohmann::json encode_profile(const ProfileSpec& profile, ArrayWriter& arrays);
/// Replaces the shape and keeps the kind of the body. `field` is the profile's path. Throws StatusError for too many
/// points, points that are not pairs, and ends in the wrong order.
void decode_profile(const nlohmann::json& source, ProfileSpec& profile, const Frames& frames, const std::string& field);

/// Encodes points as an array [n, 2] of y and z.
nlohmann::json encode_pairs(const std::vector<ProfilePoint>& points, ArrayWriter& arrays);
/// Throws StatusError naming `field` for too many points and for points that are not pairs.
std::vector<ProfilePoint> decode_pairs(const nlohmann::json& source, const Frames& frames, const std::string& field);

}  // namespace contactd::proto

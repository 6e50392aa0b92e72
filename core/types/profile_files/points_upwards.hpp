// Which way z points, as the shape of a profile says it.
#pragma once

#include <optional>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

/// Returns whether z of the points runs upwards; nothing where their shape does not say. A rail's ends lie lower than
/// what is next to them; of a wheel the flange stands out downwards. The points follow the profile, from either end.
std::optional<bool> points_upwards(const std::vector<ProfilePoint>& points, ProfileKind kind);

}  // namespace contactd::geometry

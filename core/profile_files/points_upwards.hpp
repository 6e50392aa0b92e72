// Determines the direction of z from the shape of a profile.
#pragma once

#include <optional>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

/// Returns whether z of the points runs upwards; nothing where their shape does not say. A rail's ends lie lower than
/// what is next to them; of a wheel the flange stands out downwards. The points follow the profile, from either end.
std::optional<bool> points_upwards(const std::vector<ProfilePoint>& points, ProfileKind kind);

/// Where the flange of a wheel stands out: to smaller z, or to larger ones, and nearer to the least y than to the most.
struct Flange {
    bool upwards = false, is_left = true;
};
/// Nothing where none stands out by 10 mm to one side only.
std::optional<Flange> flange_of(const std::vector<ProfilePoint>& points);

/// The coarsest step of 1, 0.1, 0.01 and 0.001 that all coordinates are multiples of; 0 where there is none.
double rounding_of(const std::vector<ProfilePoint>& points);

}  // namespace contactd::geometry

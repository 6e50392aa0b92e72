// Determines the direction of z from the shape of a profile.
#pragma once

#include <optional>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

/// Returns whether z of the points points upwards, or nothing if their shape does not show it. A rail's ends are lower
/// than the adjacent parts; a wheel's flange extends downwards. The points follow the profile, from either end.
std::optional<bool> points_upwards(const std::vector<ProfilePoint>& points, ProfileKind kind);

/// Describes the flange of a wheel: the direction of z in which it extends, and whether it is closer to the smallest or
/// the largest y.
struct Flange {
    bool upwards = false, is_left = true;
};
/// Returns nothing unless a flange extends by 10 mm to one side only.
std::optional<Flange> flange_of(const std::vector<ProfilePoint>& points);

/// Returns the coarsest step of 1, 0.1, 0.01 and 0.001 of which all coordinates are multiples, or 0 if there is none.
double rounding_of(const std::vector<ProfilePoint>& points);

}  // namespace contactd::geometry

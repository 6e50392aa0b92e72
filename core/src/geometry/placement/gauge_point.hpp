// Finds the top of a rail, and the point where its gauge is measured, on the curve of its surface.
#pragma once

#include <optional>

#include "contactd/profile.hpp"

namespace contactd::geometry {

/// Returns the place where the curve, rotated from z to y by `cant`, is highest (least z), which is the first one of a
/// plateau.
double s_of_top(const ProfileCurve& profile, double cant);

/// Returns the first s towards the curve's beginning at which the rotated curve is lower than z; absent if there is
/// none.
std::optional<double> s_of_depth(const ProfileCurve& profile, double cant, double s, double z);

/// Return the place of the least y between two places of the rotated curve, and that y.
double s_of_least_y(const ProfileCurve& profile, double cant, double from, double to);
double least_y(const ProfileCurve& profile, double cant, double from, double to);

/// Returns a point rotated by the cant.
ProfilePoint canted(const ProfilePoint& point, double cant);

}  // namespace contactd::geometry

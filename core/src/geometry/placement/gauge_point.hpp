// Where a rail is highest, and where its gauge is measured, on the curve that is its surface.
#pragma once

#include <optional>

#include "contactd/profile.hpp"

namespace contactd::geometry {

/// The place where the curve, turned from z to y by `cant`, is highest (least z); the first one of a plateau.
double s_of_top(const ProfileCurve& profile, double cant);

/// The first place from s on towards the curve's beginning that lies lower than z, once turned; absent where none does.
std::optional<double> s_of_depth(const ProfileCurve& profile, double cant, double s, double z);

/// The least y between two places, once turned.
double least_y(const ProfileCurve& profile, double cant, double from, double to);

/// A point as the cant turns it.
ProfilePoint canted(const ProfilePoint& point, double cant);

}  // namespace contactd::geometry

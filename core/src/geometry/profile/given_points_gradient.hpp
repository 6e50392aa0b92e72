// Converts a gradient by the points of a profile's curve to one by the points that make_profile received.
#pragma once

#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

/// Returns the gradient by y and z of each given point, in the unit and order in which it was given, or for a file by
/// each of its points in mm. `by_points` is that by the points of the curve. Formulae have the points of their curve
/// only, whose gradient does not change. The selection of points, their kinks and their visible part are held. Throws
/// InvalidArgument below "profile" if the curve bridges a hidden part, or is smoothed by the third order.
std::vector<ProfilePoint> by_given_points(const ProfileSpec& spec, const std::vector<ProfilePoint>& by_points);

}  // namespace contactd::geometry

// Defines parts of profiles: straight lines, arcs and polynomials, and the points on each.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

/// Describes a smooth piece of a curve as a function of a parameter from 0 to about its length.
struct Stretch {
    double length = 0;  // mm, of the parameter
    std::function<ProfilePoint(double)> at;
};

Stretch straight(ProfilePoint from, ProfilePoint to);
/// Returns an arc of a circle, from one angle to another; 0 is y, pi/2 is z.
Stretch arc(ProfilePoint centre, double radius, double from, double to);
/// Returns z = sum of powers[i] y^i.
Stretch polynomial(std::vector<double> powers, double from, double to);

/// Returns points along all stretches, each of which begins at the end of the previous one. Curvature jumps between
/// stretches, and is zero at the ends of a spline. Therefore steps are small there, and grow away from there.
std::vector<ProfilePoint> points_along(std::span<const Stretch> stretches);

}  // namespace contactd::geometry

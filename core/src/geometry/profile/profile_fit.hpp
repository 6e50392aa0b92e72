// Smooths the points of a profile part by part.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/profile.hpp"
#include "geometry/profile/cleaning.hpp"

namespace contactd::geometry {

/// Describes how points become a curve.
struct Fit {
    double length = 0, lambda = 0;  // as in ProfileFile
    int order = 2;
    KinkRule kinks{};

    bool smooths() const { return length > 0 || lambda > 0; }
};

Fit fit_of(const ProfilePoints& points);
Fit fit_of(const ProfileFile& file);

/// Returns the factors of the points from one index to another: weights are equal, or proportional to half the distance
/// of both neighbours within this part. They are larger at the fixed ends and, unless of third order, at kinks.
std::vector<double> factors_between(std::size_t count, std::size_t from, std::size_t to, const Fit& fit);
std::vector<double> weights_between(const std::vector<double>& s, std::size_t from, std::size_t to, const Fit& fit);

/// Smooths each part between kinks separately; where two meet, the mean of both is used.
Points smoothed(const ProfileCurve& rough, const Fit& fit);

/// Returns the gradient by the points of `rough` from that by the smoothed points, including that by their distances,
/// which are knots and weights. Throws InvalidArgument ("profile.smoothing_order") for the third order.
Points by_rough_points(const ProfileCurve& rough, const Fit& fit, const Points& by_smoothed);

}  // namespace contactd::geometry

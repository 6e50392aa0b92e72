// Converts a gradient by places of a profile's curve to one by the points that it passes through.
#pragma once

#include <vector>

#include "contactd/profile.hpp"

namespace contactd::geometry {

/// Accumulates the gradient of a number by points and slopes of a curve at constant s, and returns that by the points
/// of the curve. This is the transpose of the spline, whose knots move with the points.
class CurveCotangent {
   public:
    explicit CurveCotangent(ProfileCurve curve);

    /// Adds the gradient by the point at s and, if given, by the slope d/ds there. s lies on the curve.
    void add(double s, const ProfilePoint& by_point, const ProfilePoint& by_slope = {});
    /// Adds the gradient by the displacement along (-z', y') at s, and by its derivative with respect to s. The length
    /// of that normal is the speed of the curve, so a height at constant y times y' has this form.
    void add_normal(double s, double by_displacement, double by_slope = 0);

    /// Returns the gradient by y and z of each point of the curve.
    std::vector<ProfilePoint> by_points() const;
    const ProfileCurve& curve() const { return curve_; }

   private:
    struct Sums {
        std::vector<double> values, curving;  // by the values and second derivatives at the knots
    };

    void add(double s, double ProfilePoint::* coordinate, Sums& sums, double by_value, double by_slope);

    ProfileCurve curve_;
    Sums y_, z_;
    std::vector<ProfilePoint> curving_;        // at both ends of each interval, so that kinks have two
    std::vector<double> by_knots_, by_width_;  // gradient by s of knots, and by widths of intervals
};

/// Adds the gradient by the distances of neighbours to that by the points.
void add_by_widths(const std::vector<ProfilePoint>& points, const std::vector<double>& by_width,
                   std::vector<ProfilePoint>& by_points);

}  // namespace contactd::geometry

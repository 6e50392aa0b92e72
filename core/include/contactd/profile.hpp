// Represents the curve of a wheel's or a rail's profile.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd {

/// Consists of parametric cubic splines y(s), z(s) through points. s (mm) is the length of the chords from the first
/// point. The curve is C2, with natural ends, and broken at kinks, where only its points are continuous; values at a
/// kink are those after it. Its tangents extend it beyond its ends. Objects are immutable and thread-safe, and copies
/// share data.
class ProfileCurve {
   public:
    /// Holds the point of a parameter, and its first and second derivatives with respect to s.
    struct Place {
        ProfilePoint at, slope, curving;
    };

    /// `kinks` are indices of inner points, ascending. Throws InvalidArgument, which names "points[i]" or "kinks[i]",
    /// for fewer than two points, points that are not finite or beyond 1e5 mm, coincident neighbours, and kinks that
    /// are not inner points or not ascending.
    explicit ProfileCurve(std::vector<ProfilePoint> points, std::vector<std::size_t> kinks = {});

    double begin() const { return 0; }
    double end() const;

    ProfilePoint at(double s) const;
    ProfilePoint slope(double s) const;    ///< d/ds; its length is near 1
    ProfilePoint curving(double s) const;  ///< d2/ds2 (1/mm)
    Place place(double s) const;           ///< all three, at little more than the cost of one
    double angle(double s) const;          ///< angle of the tangent, atan2(dz, dy) (rad): 0 along y, pi/2 along z
    double curvature(double s) const;  ///< d angle / d arc length (1/mm): positive where the tangent turns from y to z

    double arc_length(double s) const;  ///< from the first point (mm); negative before it
    double s_at_arc_length(double arc_length) const;
    /// Returns the first s at which the curve has this y. It is fast if y of the points is monotone; otherwise it
    /// searches. For a y beyond all points, returns the nearest end of the curve.
    double s_at_y(double y) const;

    const std::vector<ProfilePoint>& points() const;
    const std::vector<std::size_t>& kinks() const;
    const std::vector<double>& knots() const;  ///< s of the points
    bool y_is_monotone() const;                ///< strictly, for the points, by at least 1e-6 mm from end to end

    /// Returns the origin of lengths across a rail, which is y = 0 or the nearest end unless another one was set.
    double middle() const { return middle_ ? *middle_ : s_at_y(0); }
    ProfileCurve counted_from(double s) const;

    /// Returns the curve with y -> -y in reverse order, so that y of the points still ascends (or descends).
    ProfileCurve mirrored() const;

   private:
    struct Tables;
    std::shared_ptr<const Tables> tables_;
    std::optional<double> middle_{};
};

}  // namespace contactd

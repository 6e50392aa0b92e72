// Describes the deviation of an out-of-round wheel from the surface of revolution of its profile.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "contactd/profile.hpp"
#include "geometry/placement/spline_along.hpp"

namespace contactd::geometry {

/// Interpolates radii by the angle about the axle and along the profile of the first slice, relative to the radii of
/// that profile.
///
/// Round the wheel, radii pass through the slices by the quintic splines of quintic_spline.hpp, whose curvature is
/// continuous. They depend on only six slices and do not overshoot a flat's edges. Between equal slices they are
/// constant, also over the long way round from the last to the first. The exception are two slices on both sides of the
/// lowest or highest point of smooth slices, as close to each other as their neighbours. spline_along.hpp describes
/// other splines. Along the profile, they are cubic splines through points 0.5 mm apart.
class OutOfRound {
   public:
    struct Place {
        double radius = 0;              ///< additional radius (mm)
        double by_angle = 0, by_s = 0;  ///< its derivatives (mm/rad, 1)
    };

    /// Angles ascend within a turn. Throws InvalidArgument ("wheel_slices[i].profile") for slices that do not end where
    /// the first one does, or with implausibly large deviations.
    OutOfRound(std::vector<double> angles, const std::vector<ProfileCurve>& slices,
               SliceSpline spline = SliceSpline::shape_preserving);

    Place at(double angle, double s) const;
    /// Returns the number of corresponding points, which are at equal fractions of each slice's length, at most half a
    /// millimetre apart.
    std::size_t nodes() const { return nodes_.size(); }
    /// Returns such a point at an angle, by the same curves round the wheel; z is relative to the nominal radius, as in
    /// slices.
    ProfilePoint node(double angle, std::size_t index) const;
    /// Returns the largest |by_angle| at the slices and between two (mm/rad).
    double steepest() const { return steepest_; }

   private:
    /// Holds values at the stations along the profile, and their second derivatives.
    struct Line {
        std::vector<double> values, curving;
    };
    struct Along {
        double value, slope;
    };

    /// Holds radii of a slice, and their derivatives round the wheel.
    struct Slice {
        Line radius, slope, curving;
    };

    /// Describes an angle between two slices by its fraction of the way from one to the next.
    struct Between {
        std::size_t slice, next;
        double width, share;
    };
    Between between(double angle) const;
    void find_nodes(const std::vector<ProfileCurve>& slices, std::span<const DerivativeShares> shares);

    std::vector<double> radii_beside(const ProfileCurve& slice, const ProfileCurve& first, std::size_t index) const;
    Along along(const Line& line, double s) const;

    SplineAlong round_;
    std::vector<double> stations_;
    std::vector<Slice> slices_;
    double steepest_ = 0;
    struct Node {
        LineAlong y, z;
    };
    std::vector<Node> nodes_;
};

}  // namespace contactd::geometry

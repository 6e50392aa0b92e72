// The deviation of an out-of-round wheel from the surface of revolution of its profile.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "contactd/profile.hpp"
#include "geometry/placement/spline_along.hpp"

namespace contactd::geometry {

/// Radii by the angle about the axle and along the profile of the first slice, beside the radii of that profile.
///
/// Round the wheel they go through the slices by the quintic splines of quintic_spline.hpp, whose curvature is
/// continuous: they depend on six slices only, do not swing beyond a flat's edges, and slices that are equal are equal
/// all between, also over the long way round from the last one to the first; but for two that lie on both sides of the
/// lowest or highest place of smooth slices, as close to each other as those beside them. Other splines are those of
/// spline_along.hpp. Along the profile they are cubic splines through points 0.5 mm apart.
class OutOfRound {
   public:
    struct Place {
        double radius = 0;              ///< what it is larger by (mm)
        double by_angle = 0, by_s = 0;  ///< its derivatives (mm/rad, 1)
    };

    /// Angles ascend within a turn. Throws InvalidArgument ("wheel_slices[i].profile") for slices that do not end where
    /// the first one does, or are out of round by more than a wheel can be.
    OutOfRound(std::vector<double> angles, const std::vector<ProfileCurve>& slices,
               SliceSpline spline = SliceSpline::shape_preserving);

    Place at(double angle, double s) const;
    /// Points that correspond: at equal shares of each slice's length, half a millimetre apart at most.
    std::size_t nodes() const { return nodes_.size(); }
    /// Returns such a point at an angle, by the same curves round the wheel; z is over the nominal radius, as slices
    /// have it.
    ProfilePoint node(double angle, std::size_t index) const;
    /// Largest |by_angle| at the slices and between two (mm/rad).
    double steepest() const { return steepest_; }

   private:
    /// Values at the stations along the profile, and their second derivatives.
    struct Line {
        std::vector<double> values, curving;
    };
    struct Along {
        double value, slope;
    };

    /// Radii of a slice, and how they go on from there round the wheel.
    struct Slice {
        Line radius, slope, curving;
    };

    /// An angle between two slices, as a share of the way from one to the next.
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

// Represents a rail whose profile varies along the track, by slices and the surface between them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "contactd/profile.hpp"
#include "geometry/placement/spline_along.hpp"

namespace contactd::geometry {

/// Interpolates along the track by splines (spline_along.hpp) through corresponding points of the slices: at equal
/// fractions of the length from feature to feature, or from kink to kink if none are given. All points use the same
/// weights of the slices for y, and the same for z. Between equal slices the profile is constant, unless other splines
/// are requested. A part begins and ends at the first and last slice that have it. Beyond the ends the profile is
/// constant.
class SlicedRail {
   public:
    struct Slice {
        double x = 0;
        ProfileCurve curve;
        std::vector<double> features{};  ///< as in RailSlice
    };

    /// Takes at least two slices, whose features have been checked; x ascends. Throws InvalidArgument for slices that
    /// cannot be joined. ("rail_slices[i].profile") means more or fewer kinks than in the first one.
    /// ("rail_slices[i].features") means features beyond the profile's end, or a slice that has no part in common with
    /// the previous one.
    explicit SlicedRail(const std::vector<Slice>& slices, SliceSpline spline = SliceSpline::shape_preserving);

    /// Returns the profile at a position along the track.
    ProfileCurve at(double x) const;
    /// Returns the position of the first slice behind x; infinite behind the last one. Up to there the surface is
    /// smooth.
    double next_slice(double x) const;

    /// Describes a position along the track: the slice before it, and the weights of that one and the next.
    struct Place {
        std::size_t slice;
        QuinticWeights weights;
    };
    Place place(double x) const;
    /// Returns the number of lines from slice to slice through corresponding points.
    std::size_t lines() const;
    /// Computes points of a line at places along the track, which are NaN where that part of the profile does not
    /// exist.
    void look_along(std::size_t line, std::span<const Place> places, std::vector<ProfilePoint>& points) const;
    /// Returns a bound on the change of any line between two places of the track (mm).
    ProfilePoint largest_change(double from, double to) const;
    /// Returns the largest |dz/dx| of all lines between two places of the track.
    double steepest(double from, double to) const;

   private:
    /// Holds a part of the profile, from the first to the last of adjacent slices that have it.
    struct Stretch {
        std::size_t first, last, part;
        SplineAlong along;
        std::vector<LineAlong> y, z;  // lines of points from slice to slice
    };
    using Ends = std::vector<double>;  // ends of the parts of a slice, as lengths; negative without the part

    void join(const std::vector<Slice>& slices, const std::vector<Ends>& ends, std::size_t part, SliceSpline spline);
    void go_along(std::size_t first, std::size_t last);
    void join_at_feature(Stretch& before, Stretch& behind);
    void find_steepest();
    std::size_t slice_before(double x) const;

    std::vector<double> x_;
    std::vector<Stretch> stretches_;         // sorted by their parts
    std::vector<ProfilePoint> steepest_;     // largest |dy/dx| and |dz/dx| behind each slice
    std::vector<std::vector<char>> kinked_;  // for each slice: whether its profile has a kink where a part begins
};

}  // namespace contactd::geometry

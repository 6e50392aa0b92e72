// A rail whose profile varies along the track: slices, and what lies between them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "contactd/profile.hpp"
#include "geometry/placement/spline_along.hpp"

namespace contactd::geometry {

/// Splines along the track (spline_along.hpp) through points of the slices that correspond: at equal shares of the
/// length from feature to feature, or from kink to kink where none are given. y of all points go by the same weights of
/// the slices, and z do. Slices that are equal are equal all between, unless other splines are asked for. A part begins
/// and ends at the slices that have it first and last. Beyond the ends the profile stays.
class SlicedRail {
   public:
    struct Slice {
        double x = 0;
        ProfileCurve curve;
        std::vector<double> features{};  ///< as RailSlice has them
    };

    /// Takes two slices at least, whose features have been checked; x ascends. Throws InvalidArgument for slices that
    /// cannot be joined: ("rail_slices[i].profile") more kinks than the first one, or fewer, and
    /// ("rail_slices[i].features") features beyond the profile's end, and slices that have no part in common with the
    /// one before.
    explicit SlicedRail(const std::vector<Slice>& slices, SliceSpline spline = SliceSpline::shape_preserving);

    /// The profile at a place along the track.
    ProfileCurve at(double x) const;
    /// Returns the place of the first slice behind x; infinite behind the last one. Up to there the surface is smooth.
    double next_slice(double x) const;

    /// A place along the track: the slice before it, and the weights of that one and the next.
    struct Place {
        std::size_t slice;
        QuinticWeights weights;
    };
    Place place(double x) const;
    /// Points that correspond lie on as many lines as this, from slice to slice.
    std::size_t lines() const;
    /// Returns where a line is at places along the track; not a number where that part of the profile does not exist.
    void look_along(std::size_t line, std::span<const Place> places, std::vector<ProfilePoint>& points) const;
    /// Returns what no line changes by more between two places of the track (mm).
    ProfilePoint largest_change(double from, double to) const;
    /// Returns the largest |dz/dx| of all lines between two places of the track.
    double steepest(double from, double to) const;

   private:
    /// A part of the profile, from the first slice to the last of some that all have it.
    struct Stretch {
        std::size_t first, last, part;
        SplineAlong along;
        std::vector<LineAlong> y, z;  // of points from slice to slice
    };
    using Ends = std::vector<double>;  // of the parts of a slice, as lengths; negative where there is none

    void join(const std::vector<Slice>& slices, const std::vector<Ends>& ends, std::size_t part, SliceSpline spline);
    void go_along(std::size_t first, std::size_t last);
    void join_at_feature(Stretch& before, Stretch& behind);
    void find_steepest();
    std::size_t slice_before(double x) const;

    std::vector<double> x_;
    std::vector<Stretch> stretches_;         // by their parts
    std::vector<ProfilePoint> steepest_;     // largest |dy/dx| and |dz/dx| behind each slice
    std::vector<std::vector<char>> kinked_;  // of each slice: whether its profile has a kink where a part begins
};

}  // namespace contactd::geometry

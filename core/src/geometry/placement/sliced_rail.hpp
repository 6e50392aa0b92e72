// A rail whose profile varies along the track: slices, and what lies between them.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/profile.hpp"
#include "geometry/placement/quintic_spline.hpp"

namespace contactd::geometry {

/// Quintic splines along the track (quintic_spline.hpp) through points of the slices that correspond: at equal shares
/// of the length from kink to kink. Slices that are equal are equal all between. Beyond the ends the profile stays.
class SlicedRail {
   public:
    /// Takes two slices at least; x ascends. Throws InvalidArgument ("rail_slices[i].profile") for slices that have
    /// more parts between kinks than the first one, or fewer: they cannot be joined.
    SlicedRail(std::vector<double> x, const std::vector<ProfileCurve>& curves);

    /// The profile at a place along the track.
    ProfileCurve at(double x) const;

   private:
    /// The line of one point from slice to slice.
    struct Line {
        std::vector<double> values;
        std::vector<KnotDerivatives> derivatives;
    };

    QuinticSpline along_;
    std::vector<Line> y_, z_;
    std::vector<std::size_t> kinks_;
};

}  // namespace contactd::geometry

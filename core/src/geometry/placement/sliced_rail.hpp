// A rail whose profile varies along the track: slices, and what lies between them.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/profile.hpp"

namespace contactd::geometry {

/// Cubic splines along the track through points of the slices that correspond: at equal shares of the length, of the
/// whole curve, or from kink to kink where all slices have as many of them. Beyond the ends the profile stays.
class SlicedRail {
   public:
    /// Of two slices at least; x ascends.
    SlicedRail(std::vector<double> x, const std::vector<ProfileCurve>& curves);

    /// The profile at a place along the track.
    ProfileCurve at(double x) const;

   private:
    /// Of one point from slice to slice.
    struct Line {
        std::vector<double> values, curving;
    };

    std::vector<double> x_;
    std::vector<Line> y_, z_;
    std::vector<std::size_t> kinks_;
};

}  // namespace contactd::geometry

// Determines whether an edge of a rail of slices may reach the wheel where the search along the locus does not look.
// Lines from slice to slice decide it at little cost.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"
#include "geometry/search/locus.hpp"

namespace contactd::geometry {

/// Returns the gap at a place as if the rail were straight from the locus to there, or less.
double expected_gap(const Locus& locus, double x, double y);

inline constexpr double known_gap = 0.02;  ///< mm: accuracy of the gap away from the locus

class EdgesAlong {
   public:
    /// The wheel stands at z = 0 and is round; the rail has slices. Both must outlive this object.
    EdgesAlong(const WheelSurface& wheel, const RailSurface& rail);

    /// Returns whether the gap of a wheelset at z may be less somewhere than the locus expects, which must have been
    /// evaluated below z. False means that CoarseMesh has nothing to find there.
    bool may_reach(const Locus& locus, double z);

   private:
    struct Place {
        double x, y, gap;  // a bound: the gap may be less
    };
    void look_below(const Locus& locus, double z);
    /// Returns a lower bound of the gap of the line, where its points are known; `y` is that of one of them.
    double floor_of(const Locus& locus, double y, const ProfilePoint& change, double steepest) const;
    void look_along_line(const Locus& locus, std::span<const ProfilePoint> line, double z);

    const WheelSurface& wheel_;
    const RailSurface& rail_;
    std::vector<double> x_;                 // of columns
    std::vector<SlicedRail::Place> there_;  // places of these along the slices
    std::vector<Place> unexpected_;         // places below the height of the last search
    double looked_below_ = -std::numeric_limits<double>::infinity();
};

}  // namespace contactd::geometry

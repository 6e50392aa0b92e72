// Finds the overlap of undeformed wheel and rail, with the common part of both searches.
#pragma once

#include <optional>
#include <vector>

#include "contactd/gap.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/search/regions.hpp"

namespace contactd::geometry {

/// Describes the elliptic contact that represents a region of overlap: semi-axes of the overlap (mm), not of the
/// contact, which is smaller, and the approach along the normal.
struct EquivalentEllipse {
    double along = 0, across = 0;
    double approach = 0;

    /// Returns the paraboloid that has this overlap at this approach.
    Paraboloid radii() const { return {along * along / (2 * approach), across * across / (2 * approach)}; }
};
inline constexpr double most_slender_ellipse = 16;  ///< ratio of semi-axes; simplified models support contacts of up to
                                                    ///< 32

/// Holds signs that a planar contact is a poor model.
struct QualityFlags {
    double bend = 0;       ///< largest angle of the rail to the plane (rad) where the surfaces are certainly pressed
                           ///< together
    double curvature = 0;  ///< curvature of the rail along the track that the search neglects, over the wheel's
    bool at_end = false;   ///< whether the overlap reaches the end of a profile
};
inline constexpr double surely_pressed = 0.04;  ///< overlap (mm) along the normal

/// Describes the deepest overlap of wheel and rail that a search does not find (mm).
struct PassedOver {
    double depth = 0;
    double x = 0, y = 0;
};

class OverlapSearch {
   public:
    virtual ~OverlapSearch() = default;
    /// Returns the least gap of a wheelset at z = 0; infinite if no part of the wheel is above the rail.
    virtual double least_gap() const = 0;
    /// Returns the regions of a wheelset at z, by descending y.
    virtual std::vector<OverlapRegion> regions(double z) = 0;
    /// Returns the ellipse of the same volume and second moments as the overlap within the group's extents.
    virtual EquivalentEllipse ellipse(double z, const RegionGroup& group) const = 0;
    virtual QualityFlags quality_flags(double z, const RegionGroup& group) const = 0;
    /// Returns an overlap outside the regions of a wheelset at z, if the search omits some of the rail.
    virtual std::optional<PassedOver> passed_over(double z) = 0;
};

}  // namespace contactd::geometry

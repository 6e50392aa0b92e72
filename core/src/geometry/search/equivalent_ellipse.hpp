// The elliptic contact that stands for a region of overlap.
#pragma once

#include "contactd/gap.hpp"
#include "geometry/search/regions.hpp"

namespace contactd::geometry {

/// Semi-axes of the overlap (mm), not of the contact, which is smaller, and the approach along the normal.
struct EquivalentEllipse {
    double along = 0, across = 0;
    double approach = 0;

    /// The paraboloid whose overlap it is, approached so far.
    Paraboloid radii() const { return {along * along / (2 * approach), across * across / (2 * approach)}; }
};

/// Of the same volume and the same second moments as the overlap of the group, at this z of the wheelset.
EquivalentEllipse equivalent_ellipse(const Locus& locus, double z, const RegionGroup& group);

}  // namespace contactd::geometry

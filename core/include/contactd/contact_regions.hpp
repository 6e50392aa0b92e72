// Regions of the potential contact area with partial interaction of their pressures.
#pragma once

#include <vector>

namespace contactd {

/// Ends of an interval (mm), from and to.
struct Extent {
    double from = 0, to = 0;

    bool operator==(const Extent&) const = default;
};

/// A rectangle of the potential contact area, in coordinates of the grid.
struct RegionLimits {
    Extent x, y;

    bool operator==(const RegionLimits&) const = default;
};

/// Regions in which bodies may touch, and the shares of the normal displacements by their pressures that act on each.
/// An element belongs to the first region that contains its centre; others cannot touch. Shares do not change
/// displacements due to tractions, or tangential ones.
struct ContactRegions {
    std::vector<RegionLimits> limits;
    /// Shape [n, n], row by row: share of the displacements by the column's region that acts on the row's, 0 to 1.
    /// Symmetric, with 1 on the diagonal.
    std::vector<double> shares;

    bool operator==(const ContactRegions&) const = default;
};

/// Throws InvalidArgument ("regions.*").
void validate(const ContactRegions& regions);

}  // namespace contactd

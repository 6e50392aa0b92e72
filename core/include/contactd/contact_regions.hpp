// Regions of the potential contact area that feel each other's pressures in part.
#pragma once

#include <vector>

namespace contactd {

/// Ends of what lies between (mm), from and to.
struct Extent {
    double from = 0, to = 0;

    bool operator==(const Extent&) const = default;
};

/// A rectangle of the potential contact area, in coordinates of the grid.
struct RegionLimits {
    Extent x, y;

    bool operator==(const RegionLimits&) const = default;
};

/// Where bodies may touch, and what share of the normal displacements by the pressures of each region acts on each. An
/// element belongs to the first region that its centre lies in; those of none cannot touch. Displacements by
/// tractions, and along the surface, act everywhere as they are.
struct ContactRegions {
    std::vector<RegionLimits> limits;
    /// Shape [n, n], row by row: of the displacements by the column's region what acts on the row's, 0 to 1. Symmetric,
    /// and 1 on the diagonal.
    std::vector<double> shares;

    bool operator==(const ContactRegions&) const = default;
};

/// Throws InvalidArgument ("regions.*").
void validate(const ContactRegions& regions);

}  // namespace contactd

// Defines regions of the potential contact area whose pressures interact only partially.
#pragma once

#include <vector>

namespace contactd {

/// Holds the ends of an interval (mm), from and to.
struct Extent {
    double from = 0, to = 0;

    bool operator==(const Extent&) const = default;
};

/// Describes a rectangle of the potential contact area, in coordinates of the grid.
struct RegionLimits {
    Extent x, y;

    bool operator==(const RegionLimits&) const = default;
};

/// Describes the regions in which bodies may touch, and the shares of the normal displacements by their pressures that
/// act on each region. An element belongs to the first region that contains its centre; elements in no region cannot
/// touch. Shares affect neither displacements due to tangential tractions nor tangential displacements.
struct ContactRegions {
    std::vector<RegionLimits> limits;
    /// Has shape [n, n], row by row. Each share, 0 to 1, is the part of the displacements by the column's region that
    /// acts on the row's region. The matrix is symmetric, with 1 on the diagonal.
    std::vector<double> shares;

    bool operator==(const ContactRegions&) const = default;
};

/// Throws InvalidArgument ("regions.*") if the regions are invalid.
void validate(const ContactRegions& regions);

}  // namespace contactd

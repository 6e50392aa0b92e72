// Regions where wheel and rail overlap, and the rules by which they become patches.
#pragma once

#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/search/locus.hpp"

namespace contactd::geometry {

/// Of a wheelset that stands at z, by descending y. Has the locus look where it must.
std::vector<OverlapRegion> overlap_regions(Locus& locus, double z, const RailSurface& rail);

/// Regions that make one patch.
struct RegionGroup {
    ContactReference reference;
    std::vector<OverlapRegion> regions;
    std::vector<double> shares;  ///< see ContactPlace
    Extent x, y, z;
    double size = 0;
};

/// Regions are those of overlap_regions. Where `blends` is false those that would feel a share of each other are groups
/// of their own, and no plane is turned.
std::vector<RegionGroup> group_regions(const std::vector<OverlapRegion>& regions, const PatchRules& rules, bool blends,
                                       const RailSurface& rail);

}  // namespace contactd::geometry

// The rules by which regions where wheel and rail overlap become patches.
#pragma once

#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/placement/rail_surface.hpp"

namespace contactd::geometry {

/// Regions that make one patch.
struct RegionGroup {
    ContactReference reference;
    std::vector<OverlapRegion> regions;
    std::vector<double> shares;  ///< see ContactPlace
    Extent x, y, z;
    double size = 0;
};

/// Regions are those of an OverlapSearch. Where `blends` is false those that would have a weighted interaction are
/// groups of their own, and no plane is turned.
std::vector<RegionGroup> group_regions(const std::vector<OverlapRegion>& regions, const PatchRules& rules, bool blends,
                                       const RailSurface& rail);

}  // namespace contactd::geometry

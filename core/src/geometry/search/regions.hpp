// Defines the rules by which regions of overlap of wheel and rail become patches.
#pragma once

#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/placement/rail_surface.hpp"

namespace contactd::geometry {

/// Holds regions that form one patch.
struct RegionGroup {
    ContactReference reference;
    std::vector<OverlapRegion> regions;
    std::vector<double> shares;  ///< see ContactPlace
    Extent x, y, z;
    double size = 0;
};

/// Groups the regions of an OverlapSearch. If `blends` is false, those that would have a weighted interaction are
/// separate groups, and planes are not rotated.
std::vector<RegionGroup> group_regions(const std::vector<OverlapRegion>& regions, const PatchRules& rules, bool blends,
                                       const RailSurface& rail);

}  // namespace contactd::geometry

// The grid of a patch: multiples of the elements' sizes around its reference, or of a transient contact elsewhere.
#pragma once

#include <vector>

#include "contactd/grid.hpp"
#include "geometry/search/regions.hpp"

namespace contactd::geometry {

/// Of an element, in the coordinates of a contact (mm).
struct ElementMiddle {
    double x = 0, y = 0;
};

/// From one element before the group's extents to one behind them; the middle of one is at `middle`, 0 <= x < dx and
/// 0 <= y < dy. Throws InvalidArgument ("dx") where these would be too many.
Grid grid_of(const RegionGroup& group, const RailSurface& rail, double dx, double dy, const ElementMiddle& middle = {});

/// Arc length across the rail at a y of the track (mm), from the first point of its profile with y >= 0.
double across_rail(const RailSurface& rail, double y);

/// Adds elements where the overlap reaches the border, which is known by vertical distances only: true where it did.
bool grow(Grid& grid, const std::vector<double>& gap, double approach);

/// Adds elements for all of an ellipse at the origin with these semi-axes (mm).
void cover(Grid& grid, double along, double across);

}  // namespace contactd::geometry

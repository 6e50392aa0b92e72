// The grid of a patch: multiples of the elements' sizes around its reference.
#pragma once

#include <vector>

#include "contactd/grid.hpp"
#include "geometry/search/regions.hpp"

namespace contactd::geometry {

/// From one element before the group's extents to one behind them. Throws InvalidArgument ("dx") where these would be
/// too many.
Grid grid_of(const RegionGroup& group, const RailSurface& rail, double dx, double dy);

/// Adds elements where the overlap reaches the border, which is known by vertical distances only: true where it did.
bool grow(Grid& grid, const std::vector<double>& gap, double approach);

/// Adds elements for all of an ellipse at the origin with these semi-axes (mm).
void cover(Grid& grid, double along, double across);

}  // namespace contactd::geometry

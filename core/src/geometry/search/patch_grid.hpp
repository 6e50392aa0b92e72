// The grid of a patch: multiples of the elements' sizes around its reference, or of a transient contact elsewhere.
#pragma once

#include <vector>

#include "contactd/grid.hpp"
#include "geometry/distance/heights.hpp"
#include "geometry/search/regions.hpp"

namespace contactd::geometry {

/// From one element before the group's extents to one behind them; the middle of one is at `middle`, 0 <= x < dx and
/// 0 <= y < dy. As long as there are `most` elements (0: any number), they are made twice as long and as wide, where
/// they are more than ten. Throws InvalidArgument ("dx") where these would be too many.
Grid grid_of(const RegionGroup& group, const RailSurface& rail, double dx, double dy, const ElementMiddle& middle = {},
             int most = 0);

/// Arc length at the middle of a profile (mm), from which lengths across it are counted.
double arc_length_of_middle(const ProfileCurve& profile);
/// Arc length across the rail at a y of the track (mm), from there.
double across_rail(const RailSurface& rail, double y);

/// Throws InvalidArgument ("dx") for more elements than a patch may have.
void check_size(const Grid& grid);

/// Adds elements up to convenient numbers of them, so that contacts which move need few operators; rows only where
/// `all_rows` says so, and none to large grids.
Grid convenient(Grid grid, bool all_rows);

/// Adds elements where the overlap reaches the border, which is known by vertical distances only: true where it did.
bool grow(Grid& grid, const std::vector<double>& gap, double approach);

/// Adds elements for all of an ellipse at the origin with these semi-axes (mm).
void cover(Grid& grid, double along, double across);

}  // namespace contactd::geometry

// Computes the grid of a patch, at multiples of the elements' sizes from its reference, or for a transient contact from
// another point.
#pragma once

#include <vector>

#include "contactd/grid.hpp"
#include "geometry/distance/heights.hpp"
#include "geometry/search/regions.hpp"

namespace contactd::geometry {

/// Returns the grid from one element before the group's extents to one behind them. The middle of an element is at
/// `middle`, 0 <= x < dx and 0 <= y < dy. Elements are doubled in length and width while there are `most` or more (0:
/// never), in directions with more than ten. Throws InvalidArgument ("dx") if there are still too many.
Grid grid_of(const RegionGroup& group, const RailSurface& rail, double dx, double dy, const ElementMiddle& middle = {},
             int most = 0);

/// Returns the arc length at the middle of a profile (mm), from which lengths across it are counted.
double arc_length_of_middle(const ProfileCurve& profile);
/// Returns the arc length across the rail at a y of the track (mm), counted from the middle.
double across_rail(const RailSurface& rail, double y);

/// Throws InvalidArgument ("dx") if there are more elements than a patch may have.
void check_size(const Grid& grid);

/// Adds elements up to convenient numbers, so that moving contacts need few operators. Rows are only added with
/// `all_rows`, and nothing is added to large grids.
Grid convenient(Grid grid, bool all_rows);

/// Adds elements where the overlap reaches the border, because the search uses vertical distances only. Returns true if
/// it did.
bool grow(Grid& grid, const std::vector<double>& gap, double approach);

/// Adds elements to cover an ellipse at the origin with these semi-axes (mm).
void cover(Grid& grid, double along, double across);

}  // namespace contactd::geometry

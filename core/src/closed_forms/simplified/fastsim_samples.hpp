// FASTSIM's tractions and slip at the centres of elements.
#pragma once

#include "fastsim_ellipse.hpp"

namespace contactd {

/// Sets the arrays of `result`, which have the grid's size, inside the ellipse. They are found along the elements of a
/// row or column where that is the rolling direction, else from the edge each time, by at most `steps` steps a slice
/// and one more for each element. Forces do not come from them.
void sample(const Grid& grid, const RollingFrame& frame, const FastsimEllipse& ellipse,
            const FastsimCreepages<double>& creepages, int steps, EllipticFriction& result);

}  // namespace contactd

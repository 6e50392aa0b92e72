// Samples FASTSIM's tractions and slip at the centres of elements.
#pragma once

#include "fastsim_ellipse.hpp"

namespace contactd {

/// Sets the arrays of `result`, which have the grid's size, inside the ellipse. If the rolling direction is along a row
/// or column, they are computed along its elements. Otherwise they are computed from the edge each time. A slice has at
/// most `steps` steps and one more for each element. Forces are not computed from these samples.
void sample(const Grid& grid, const RollingFrame& frame, const FastsimEllipse& ellipse,
            const FastsimCreepages<double>& creepages, int steps, EllipticFriction& result);

}  // namespace contactd

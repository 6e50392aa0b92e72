// Computes coefficients of layered bodies at points some distance away from the element centres.
#pragma once

#include "contactd/layers.hpp"
#include "contactd/observer.hpp"
#include "influence/shifted_table.hpp"

namespace contactd {

/// Returns coefficients of layers below a rigid body. Only the numbers and the sizes of the elements of `grid` matter.
/// They are as exact as those of layered_table, also on the borders between elements.
ShiftedTable shifted_layers(const Layers& body, LoadShape load_shape, const Grid& grid, double shift_x, double shift_y,
                            const Observer& observer = {});

}  // namespace contactd

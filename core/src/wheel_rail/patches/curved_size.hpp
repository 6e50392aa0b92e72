// Bounds of patches whose coefficients differ from row to row.
#pragma once

#include "contactd/grid.hpp"

namespace contactd {

/// Throws InvalidArgument ("dy") where coefficients would be too many.
void check_curved_size(const Grid& grid);

}  // namespace contactd

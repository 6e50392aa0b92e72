// Limits patches whose coefficients differ between rows.
#pragma once

#include "contactd/grid.hpp"

namespace contactd {

/// Throws InvalidArgument ("dy") if there are too many coefficients.
void check_curved_size(const Grid& grid);

}  // namespace contactd

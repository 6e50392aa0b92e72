// Computes heights of half an ellipsoid over the element centres, which have the shape of Hertz's pressure.
#pragma once

#include <span>

#include "contactd/gap.hpp"
#include "contactd/grid.hpp"

namespace contactd {

struct SemiEllipsoid {
    SemiAxes axes;        ///< a semi-axis may be infinite
    double share = 1;     ///< its size over that of its axes
    double x = 0, y = 0;  ///< centre
};

/// Computes sqrt(share^2 - (x - xc)^2/a^2 - (y - yc)^2/b^2) along row iy of the grid, and zero outside. `heights` has
/// as many entries as the row has elements.
void heights_along(const Grid& grid, int iy, const SemiEllipsoid& of, std::span<double> heights);

}  // namespace contactd

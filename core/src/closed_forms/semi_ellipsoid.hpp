// Heights of half an ellipsoid over the element centres: the shape of Hertz's pressure.
#pragma once

#include <span>

#include "contactd/gap.hpp"
#include "contactd/grid.hpp"

namespace contactd {

struct SemiEllipsoid {
    SemiAxes axes;        ///< a semi-axis may be infinite
    double share = 1;     ///< of its size in that of its axes
    double x = 0, y = 0;  ///< centre
};

/// sqrt(share^2 - (x - xc)^2/a^2 - (y - yc)^2/b^2) along row iy of the grid, which has as many elements as `heights`;
/// zero outside.
void heights_along(const Grid& grid, int iy, const SemiEllipsoid& of, std::span<double> heights);

}  // namespace contactd

#include "semi_ellipsoid.hpp"

#include <cmath>
#include <cstddef>

#include "types/simd.hpp"

namespace contactd {

CONTACTD_SIMD
static void fill(double first, double step, double rest, std::span<double> heights) {
    double* const out = heights.data();
    const int count = static_cast<int>(heights.size());
#pragma omp simd
    for (int i = 0; i < count; ++i) {
        const double x = first + i * step, square = rest - x * x;
        out[i] = std::sqrt(square > 0 ? square : 0);
    }
}

void heights_along(const Grid& grid, int iy, const SemiEllipsoid& of, std::span<double> heights) {
    const double y = (grid.y(iy) - of.y) / of.axes.b;
    fill((grid.x(0) - of.x) / of.axes.a, grid.dx / of.axes.a, of.share * of.share - y * y, heights);
}

}  // namespace contactd

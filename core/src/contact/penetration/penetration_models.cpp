#include "penetration_models.hpp"

#include <algorithm>
#include <cmath>

#include "closed_forms/hertz.hpp"

namespace contactd {
namespace {

HertzContact hertz(double along, double across, double compliance, double approach) {
    return hertz_of_approach({0.5 / along, 0.5 / across}, compliance, approach);
}

void add_half_ellipse(const DistanceRows& rows, int iy, const RowExtent& extent, double height, double threshold,
                      std::vector<double>& pressure) {
    const Grid& grid = rows.grid();
    const auto distance = rows.row(iy);
    const std::size_t begin = static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx);
    for (int ix = 0; ix < grid.nx; ++ix) {
        const auto place = static_cast<std::size_t>(ix);
        const double x = grid.x(ix) - extent.middle, square = extent.half * extent.half - x * x;
        if (square > 0 && distance[place] < threshold) pressure[begin + place] = height * std::sqrt(square);
    }
}

PenetrationPressures none_of(const DistanceRows& rows) {
    return {std::vector<double>(rows.grid().size()), false};
}

}  // namespace

PenetrationPressures kp_shape(const DistanceRows& rows, double d) {
    constexpr double share = 0.55;
    PenetrationPressures found = none_of(rows);
    const double threshold = rows.least() + share * d;
    for (int iy = 0; iy < rows.grid().ny; ++iy)
        if (const auto extent = rows.below(iy, threshold))
            add_half_ellipse(rows, iy, *extent, 1, threshold, found.pressure);
    return found;
}

PenetrationPressures kpec_shape(const DistanceRows& rows, double d, double compliance) {
    PenetrationPressures found = none_of(rows);
    const auto across = rows.rows_below(rows.least() + 0.5 * d);
    const double half = across ? across->half : 0.5 * rows.grid().dy, ym = across ? across->middle : 0;
    const double A = std::max(rows.parabola(rows.deepest_row()).curvature, least_along);
    const double B = std::max(0.5 * d / (half * half), least_across);
    const HertzContact ellipse = hertz(A, B, compliance, d);
    const double middle = A * ellipse.a * ellipse.a, edge = B * ellipse.b * ellipse.b;
    for (int iy = 0; iy < rows.grid().ny; ++iy) {
        const double y = (rows.grid().y(iy) - ym) / ellipse.b, height = middle - (middle - edge) * (y * y);
        const double threshold = rows.least() + std::clamp(height, 0.0, d);
        const auto extent = rows.below(iy, threshold);
        if (!extent) continue;
        found.is_beyond = found.is_beyond || height > d;
        add_half_ellipse(rows, iy, *extent, 1, threshold, found.pressure);
    }
    return found;
}

PenetrationPressures analyn_pressures(const DistanceRows& rows, double d, double compliance) {
    PenetrationPressures found = none_of(rows);
    const Grid& grid = rows.grid();
    const auto height = [&](int iy) { return rows.parabola(iy).least - rows.least(); };
    constexpr double everywhere = 1e300;
    for (int iy = 0; iy < grid.ny; ++iy) {
        if (!(height(iy) < d)) continue;  // The divisor of Hertz's contact below is smaller than d.
        const double curvature = rows.curvature_across(iy);
        const double A = std::max(rows.parabola(iy).curvature, least_along), B = std::max(curvature, least_across);
        const HertzContact ellipse = hertz(A, B, compliance, d);
        const double rest = d - d / (B * ellipse.b * ellipse.b) * height(iy);
        if (!(rest > 0)) continue;
        found.is_beyond = found.is_beyond || !(curvature > least_across);
        // Hertz's contacts of the same surfaces are similar.
        const double size = std::sqrt(rest / d), half = ellipse.a * size, pmax = ellipse.pmax * size;
        add_half_ellipse(rows, iy, {rows.parabola(iy).middle, half}, pmax / half, everywhere, found.pressure);
    }
    return found;
}

}  // namespace contactd

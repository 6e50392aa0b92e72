#include "distance_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace contactd {
namespace {

// Values at equal steps: where they fall below a threshold and rise above it again, by straight lines between them.
template <class Value>
std::optional<RowExtent> extent_below(int count, double first, double step, double threshold, Value value) {
    int from = 0, to = count - 1;
    while (from < count && !(value(from) < threshold)) ++from;
    if (from == count) return {};
    while (!(value(to) < threshold)) --to;
    const auto way = [&](int inside, int outside) {
        if (outside < 0 || outside >= count) return 0.5;  // it ends with the grid
        return (threshold - value(inside)) / (value(outside) - value(inside));
    };
    const double low = first + step * (from - way(from, from - 1)), high = first + step * (to + way(to, to + 1));
    return RowExtent{0.5 * (low + high), 0.5 * (high - low)};
}

// The parabola by least squares of the values that lie less than `depth` above the least one, three of them at least.
// Sums are taken about the element of the least one, in units of elements.
RowParabola parabola_of(const Grid& grid, std::span<const double> row, double depth) {
    const auto lowest = static_cast<int>(std::ranges::min_element(row) - row.begin());
    const double least = row[static_cast<std::size_t>(lowest)];
    RowParabola result{grid.x(lowest), least, 0};
    if (grid.nx < 3) return result;
    const auto value = [&](int ix) { return row[static_cast<std::size_t>(ix)] - least; };
    int from = std::clamp(lowest - 1, 0, grid.nx - 3), to = from + 2;
    while (from > 0 && value(from - 1) < depth) --from;
    while (to < grid.nx - 1 && value(to + 1) < depth) ++to;
    std::array<double, 5> t{};
    std::array<double, 3> f{};
    for (int ix = from; ix <= to; ++ix) {
        const double s = ix - lowest;
        double power = 1;
        for (std::size_t k = 0; k < 5; ++k, power *= s) {
            t[k] += power;
            if (k < 3) f[k] += power * value(ix);
        }
    }
    // Cramer's rule for c0 + c1 s + c2 s^2.
    const auto determinant = [](double a, double b, double c, double d, double e, double g, double h, double i,
                                double j) { return a * (e * j - g * i) - b * (d * j - g * h) + c * (d * i - e * h); };
    const double all = determinant(t[0], t[1], t[2], t[1], t[2], t[3], t[2], t[3], t[4]);
    const double c0 = determinant(f[0], t[1], t[2], f[1], t[2], t[3], f[2], t[3], t[4]) / all;
    const double c1 = determinant(t[0], f[0], t[2], t[1], f[1], t[3], t[2], f[2], t[4]) / all;
    const double c2 = determinant(t[0], t[1], f[0], t[1], t[2], f[1], t[2], t[3], f[2]) / all;
    if (!(c2 > 0)) return result;
    const double vertex = std::clamp(-0.5 * c1 / c2, -1.0, 1.0);  // next to the least value
    result.middle += vertex * grid.dx;
    result.least += c0 + vertex * (c1 + vertex * c2);
    result.curvature = c2 / (grid.dx * grid.dx);
    return result;
}

}  // namespace

DistanceRows::DistanceRows(const Grid& grid, std::span<const double> distance, double depth)
    : grid_(grid), distance_(distance.begin(), distance.end()) {
    deepest_element_ = static_cast<std::size_t>(std::ranges::min_element(distance_) - distance_.begin());
    deepest_row_ = static_cast<int>(deepest_element_ / static_cast<std::size_t>(grid.nx));
    parabolas_.reserve(static_cast<std::size_t>(grid.ny));
    for (int iy = 0; iy < grid.ny; ++iy) parabolas_.push_back(parabola_of(grid, row(iy), depth));
    least_ = std::min(parabola(deepest_row_).least, distance_[deepest_element_]);
}

std::span<const double> DistanceRows::row(int iy) const {
    const auto columns = static_cast<std::size_t>(grid_.nx);
    return std::span(distance_).subspan(static_cast<std::size_t>(iy) * columns, columns);
}

std::optional<RowExtent> DistanceRows::below(int iy, double threshold) const {
    const auto values = row(iy);
    return extent_below(grid_.nx, grid_.x(0), grid_.dx, threshold,
                        [&](int ix) { return values[static_cast<std::size_t>(ix)]; });
}

std::optional<RowExtent> DistanceRows::rows_below(double threshold) const {
    return extent_below(grid_.ny, grid_.y(0), grid_.dy, threshold, [&](int iy) { return parabola(iy).least; });
}

}  // namespace contactd

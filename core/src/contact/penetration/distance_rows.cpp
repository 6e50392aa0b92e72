#include "distance_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace contactd {
namespace {

// Returns where values at equal steps fall below a threshold and rise above it again, with linear interpolation.
template <class Value>
std::optional<RowExtent> extent_below(int count, double first, double step, double threshold, Value value) {
    int from = 0, to = count - 1;
    while (from < count && !(value(from) < threshold)) ++from;
    if (from == count) return {};
    while (!(value(to) < threshold)) --to;
    const auto way = [&](int inside, int outside) {
        if (outside < 0 || outside >= count) return 0.5;  // It ends with the grid.
        return (threshold - value(inside)) / (value(outside) - value(inside));
    };
    const double low = first + step * (from - way(from, from - 1)), high = first + step * (to + way(to, to + 1));
    return RowExtent{0.5 * (low + high), 0.5 * (high - low)};
}

/// Returns the sums of the powers 0 to 4 of the whole numbers from `from` to `to`.
std::array<double, 5> power_sums(int from, int to) {
    const auto up_to = [](double n) -> std::array<double, 5> {
        const double first = 0.5 * n * (n + 1);
        return {n, first, first * (2 * n + 1) / 3, first * first, first * (2 * n + 1) * (3 * n * n + 3 * n - 1) / 15};
    };
    const auto all = up_to(to), below = up_to(from - 1);
    std::array<double, 5> sums{};
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = all[k] - below[k];
    return sums;
}

// Fits a parabola by least squares to the values that are less than `depth` above the least one, at least three of
// them. Sums are taken about the element of the least one, in units of elements.
RowParabola parabola_of(const Grid& grid, std::span<const double> row, int lowest, double depth) {
    const double least = row[static_cast<std::size_t>(lowest)];
    RowParabola result{grid.x(lowest), least, 0};
    if (grid.nx < 3) return result;
    const auto value = [&](int ix) { return row[static_cast<std::size_t>(ix)] - least; };
    int from = std::clamp(lowest - 1, 0, grid.nx - 3), to = from + 2;
    while (from > 0 && value(from - 1) < depth) --from;
    while (to < grid.nx - 1 && value(to + 1) < depth) ++to;
    const std::array<double, 5> t = power_sums(from - lowest, to - lowest);
    std::array<double, 3> f{};
    for (int ix = from; ix <= to; ++ix) {
        const double s = ix - lowest, h = value(ix);
        f[0] += h;
        f[1] += s * h;
        f[2] += s * s * h;
    }
    // Cramer's rule solves for c0 + c1 s + c2 s^2.
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

DistanceRows::DistanceRows(const Grid& grid, std::span<const double> distance)
    : grid_(grid), distance_(distance), parabolas_(static_cast<std::size_t>(grid.ny)) {
    lowest_.reserve(parabolas_.size());
    double least = distance[0];
    for (int iy = 0; iy < grid.ny; ++iy) {
        const auto values = row(iy);
        const auto lowest = std::ranges::min_element(values);
        lowest_.push_back(static_cast<int>(lowest - values.begin()));
        if (iy > 0 && !(*lowest < least)) continue;
        least = *lowest;
        deepest_row_ = iy;
    }
    deepest_element_ = static_cast<std::size_t>(deepest_row_) * static_cast<std::size_t>(grid.nx) +
                       static_cast<std::size_t>(lowest_[static_cast<std::size_t>(deepest_row_)]);
    take_parabolas(0);
}

void DistanceRows::take_parabolas(double depth) {
    for (int iy = 0; iy < grid_.ny; ++iy) {
        const auto at = static_cast<std::size_t>(iy);
        parabolas_[at] = parabola_of(grid_, row(iy), lowest_[at], depth);
    }
    least_ = std::min(parabola(deepest_row_).least, distance_[deepest_element_]);
}

double DistanceRows::curvature_across(int iy) const {
    if (grid_.ny < 3) return 0;
    const int inner = std::clamp(iy, 1, grid_.ny - 2);
    const double second = parabola(inner + 1).least - 2 * parabola(inner).least + parabola(inner - 1).least;
    return 0.5 * second / (grid_.dy * grid_.dy);
}

std::array<double, 2> DistanceRows::curvatures() const {
    return {std::max(parabola(deepest_row_).curvature, least_along),
            std::max(curvature_across(deepest_row_), least_across)};
}

std::span<const double> DistanceRows::row(int iy) const {
    const auto columns = static_cast<std::size_t>(grid_.nx);
    return distance_.subspan(static_cast<std::size_t>(iy) * columns, columns);
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

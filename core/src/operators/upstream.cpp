#include "upstream.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace contactd {
namespace {

constexpr double negligible = 1e-9;  // weight of a neighbour

// Describes a length along an axis in elements, split for linear interpolation between the two nearest ones.
struct ElementsAhead {
    int first;      // nearer one, towards the leading edge
    int direction;  // direction of the particle's origin
    std::array<double, 2> weights;

    explicit ElementsAhead(double elements) {
        const double length = std::abs(elements);
        direction = elements < 0 ? -1 : 1;
        // At larger distances nothing is inside the contact; the bound keeps the cast defined.
        first = static_cast<int>(std::min(std::floor(length + negligible), 1e8));
        const double fraction = std::clamp(length - first, 0.0, 1.0);
        weights = {1 - fraction, fraction};
    }
};

}  // namespace

std::vector<ElementAhead> elements_ahead(const Grid& grid, double step_x, double step_y) {
    const ElementsAhead along_x(step_x / grid.dx), along_y(step_y / grid.dy);
    std::vector<ElementAhead> result;
    for (const int b : {0, 1})
        for (const int a : {0, 1}) {
            const ElementAhead ahead{
                along_x.direction * (along_x.first + a), along_y.direction * (along_y.first + b),
                along_x.weights[static_cast<std::size_t>(a)] * along_y.weights[static_cast<std::size_t>(b)]};
            if (ahead.weight >= negligible) result.push_back(ahead);
        }
    return result;
}

Upstream::Upstream(const Grid& grid, double step_x, double step_y, std::span<const std::size_t> elements) {
    std::vector<ElementAhead> offsets;
    for (const ElementAhead& ahead : elements_ahead(grid, step_x, step_y))
        if (ahead.x == 0 && ahead.y == 0)
            diagonal_ -= ahead.weight;
        else
            offsets.push_back(ahead);
    const std::size_t m = elements.size();
    links_ = offsets.size();
    order_.reserve(m);
    ahead_.reserve(m * links_);
    std::vector<std::size_t> element_at(grid.size(), m);
    for (std::size_t e = 0; e < m; ++e) element_at[elements[e]] = e;
    // Adjacent elements in the order do not depend on each other if particles move along an axis.
    const bool by_columns = std::abs(step_x / grid.dx) >= std::abs(step_y / grid.dy);
    const int outer_size = by_columns ? grid.nx : grid.ny, inner_size = by_columns ? grid.ny : grid.nx;
    for (int outer = 0; outer < outer_size; ++outer)
        for (int inner = 0; inner < inner_size; ++inner) {
            const int column = by_columns ? outer : inner, row = by_columns ? inner : outer;
            const int ix = step_x >= 0 ? grid.nx - 1 - column : column;
            const int iy = step_y >= 0 ? grid.ny - 1 - row : row;
            const auto at = [&](int x, int y) {
                const bool inside = x >= 0 && x < grid.nx && y >= 0 && y < grid.ny;
                return inside ? element_at[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) +
                                           static_cast<std::size_t>(x)]
                              : m;
            };
            const std::size_t e = at(ix, iy);
            if (e == m) continue;
            order_.push_back(e);
            for (const ElementAhead& offset : offsets)
                ahead_.push_back({at(ix + offset.x, iy + offset.y), offset.weight});
        }
}

std::vector<double> one_step_ahead(const Grid& grid, double step_x, double step_y, std::span<const double> values,
                                   double entering) {
    const std::vector<ElementAhead> neighbours = elements_ahead(grid, step_x, step_y);
    std::vector<double> result(values.size());
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i)
            for (const ElementAhead& ahead : neighbours) {
                const int x = ix + ahead.x, y = iy + ahead.y;
                const bool inside = x >= 0 && x < grid.nx && y >= 0 && y < grid.ny;
                const auto at =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
                result[i] += ahead.weight * (inside ? values[at] : entering);
            }
    return result;
}

}  // namespace contactd

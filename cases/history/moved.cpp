#include "moved.hpp"

#include <cmath>
#include <cstddef>

#include "contactd/fields/grid_arrays.hpp"

namespace contactd::cases {
namespace {

double moved_by_whole(double requested, double before, double size) {
    return before + std::nearbyint((requested - before) / size) * size;
}

}  // namespace

Grid continued(const Grid& requested, const Grid& before) {
    Grid grid = before;
    grid.nx = requested.nx;
    grid.ny = requested.ny;
    grid.x0 = moved_by_whole(requested.x0, before.x0, before.dx);
    grid.y0 = moved_by_whole(requested.y0, before.y0, before.dy);
    return grid;
}

std::vector<double> on_grid(const std::vector<double>& values, const Grid& from, const Grid& to,
                            const std::vector<double>& elsewhere) {
    if (values.empty() || from == to) return values;
    const int dx = static_cast<int>(std::lround((to.x0 - from.x0) / from.dx));
    const int dy = static_cast<int>(std::lround((to.y0 - from.y0) / from.dy));
    std::vector<double> moved;
    moved.reserve(to.size());
    for (int iy = 0; iy < to.ny; ++iy)
        for (int ix = 0; ix < to.nx; ++ix) {
            const int x = ix + dx, y = iy + dy;
            const bool is_there = x >= 0 && x < from.nx && y >= 0 && y < from.ny;
            const auto at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(from.nx) + static_cast<std::size_t>(x);
            moved.push_back(is_there ? values[at] : elsewhere[elsewhere.size() == 1 ? 0 : moved.size()]);
        }
    return moved;
}

SurfaceState on_grid(const SurfaceState& state, const Grid& from, const Grid& to, const FrictionLaw& friction) {
    if (from == to) return state;
    SurfaceState moved;
    for (const HistoryArray& array : history_arrays) {
        std::vector<double> elsewhere{0};
        if (!array.is_traction()) {
            if (!array.entering(friction, 0)) continue;
            elsewhere.resize(to.size());
            for (std::size_t i = 0; i < elsewhere.size(); ++i) elsewhere[i] = *array.entering(friction, i);
        }
        moved.*array.before = on_grid(state.*array.before, from, to, elsewhere);
    }
    return moved;
}

}  // namespace contactd::cases

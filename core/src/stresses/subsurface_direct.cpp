#include "subsurface_direct.hpp"

#include <algorithm>
#include <limits>

namespace contactd {

LoadedPatch::LoadedPatch(const Grid& grid, const SurfaceTractions& tractions, RowEnds ends)
    : grid_(grid), ends_(ends), first_x_(grid.nx), first_y_(grid.ny) {
    const double dy = ends == RowEnds::grid ? grid.dy : std::numeric_limits<double>::infinity();
    const std::array<const std::vector<double>*, 3> all = {&tractions.x, &tractions.y, &tractions.z};
    int last_x = -1, last_y = -1;
    for (const auto* values : all)
        for (std::size_t e = 0; e < values->size(); ++e) {
            if ((*values)[e] == 0) continue;
            const int ix = static_cast<int>(e) % grid.nx, iy = static_cast<int>(e) / grid.nx;
            first_x_ = std::min(first_x_, ix);
            last_x = std::max(last_x, ix);
            first_y_ = std::min(first_y_, iy);
            last_y = std::max(last_y, iy);
        }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<double>& values = *all[axis];
        TractionPatch& load = loads_[axis];
        load = {std::max(0, last_x - first_x_ + 1), std::max(0, last_y - first_y_ + 1), grid.dx, dy, {}};
        if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0; })) continue;
        for (int iy = first_y_; iy <= last_y; ++iy) {
            const auto row = values.begin() + static_cast<std::ptrdiff_t>(iy) * grid.nx;
            load.values.insert(load.values.end(), row + first_x_, row + last_x + 1);
        }
    }
}

std::vector<LoadedCorner> corners_of(const LoadedPatch& patch) {
    std::vector<LoadedCorner> corners;
    const int nx = patch.nx(), ny = patch.ny();
    for (int l = 0; l <= ny; ++l)
        for (int k = 0; k <= nx; ++k) {
            LoadedCorner corner{
                patch.x() + (k - 0.5) * patch.loads()[0].dx, patch.y() + (l - 0.5) * patch.loads()[0].dy, {}};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto& values = patch.loads()[axis].values;
                const auto at = [&](int ix, int iy) {
                    const bool inside = ix >= 0 && ix < nx && iy >= 0 && iy < ny && !values.empty();
                    return inside ? values[static_cast<std::size_t>(iy) * nx + ix] : 0;
                };
                corner.jump[axis] = (at(k, l) - at(k - 1, l)) - (at(k, l - 1) - at(k - 1, l - 1));
            }
            if (corner.jump != std::array<double, 3>{}) corners.push_back(corner);
        }
    return corners;
}

}  // namespace contactd

#include "estimates.hpp"

#include <cmath>
#include <cstddef>

#include "contactd/fields/grid_arrays.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;
using Patch = WheelRailEstimates::Patch;

const Patch* nearest(const ContactPlace& place, const std::vector<Patch>& patches) {
    const Patch* best = nullptr;
    double least = 0.5 * place.grid.ny * place.grid.dy;  // Farther away, it would be the pressure of another contact.
    for (const Patch& patch : patches) {
        const double distance = std::abs(patch.y - place.reference.y);
        if (patch.grid.dx != place.grid.dx || patch.grid.dy != place.grid.dy || distance >= least) continue;
        least = distance;
        best = &patch;
    }
    return best;
}

/// Moves values to the same position about the reference, rounded to elements, with zeros beside it.
Values moved(const Values& values, const Grid& from, const Grid& to) {
    if (values.empty()) return {};
    const auto ix = static_cast<int>(std::lround((to.x0 - from.x0) / to.dx));
    const auto iy = static_cast<int>(std::lround((to.y0 - from.y0) / to.dy));
    if (ix == 0 && iy == 0 && from.nx == to.nx && from.ny == to.ny) return values;
    Values result(to.size());
    for (int row = 0; row < to.ny; ++row)
        for (int column = 0; column < to.nx; ++column) {
            const int x = column + ix, y = row + iy;
            if (x < 0 || x >= from.nx || y < 0 || y >= from.ny) continue;
            const auto at = [](const Grid& grid, int i, int k) {
                return static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(i);
            };
            result[at(to, column, row)] = values[at(from, x, y)];
        }
    return result;
}

}  // namespace

SurfaceState estimate_for(const ContactPlace& place, const std::vector<Patch>& before) {
    const Patch* patch = nearest(place, before);
    if (patch == nullptr) return {};
    const auto of = [&](const Values& values) { return moved(values, patch->grid, place.grid); };
    SurfaceState estimate;
    for (const HistoryArray& array : history_arrays)
        if (array.is_traction()) estimate.*array.before = of(patch->tractions.*array.before);
    return estimate;
}

Patch estimate_of(const geometry::CandidatePatch& found, double x, const ContactSolution& solution) {
    return {found.place.grid, found.place.reference.y, found.place.on_rail, x, end_of(solution)};
}

}  // namespace contactd

#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/distance/heights.hpp"

namespace contactd::geometry {
namespace {

/// Returns the slope from the heights on both sides, or on the one that exists.
double slope_between(const std::vector<double>& heights, std::size_t row, int ix, const Grid& grid) {
    const auto height = [&](int column) {
        return column < 0 || column >= grid.nx ? no_height : heights[row + static_cast<std::size_t>(column)];
    };
    const int before = std::isfinite(height(ix - 1)) ? ix - 1 : ix,
              behind = std::isfinite(height(ix + 1)) ? ix + 1 : ix;
    return before == behind ? no_height : (height(behind) - height(before)) / ((behind - before) * grid.dx);
}

}  // namespace

// The plane leans only across the track, so the rail's rise over it is its fall in the track times the cosine.
SlopesAlong rail_slopes(const RailSurface& rail, const ContactReference& reference) {
    if (!rail.varies()) return {};
    double s = 0.5 * (rail.visible().from + rail.visible().to);
    rail.find_y(reference.y, s);
    const double slope = rail.slope_along(reference.x, reference.y, rail.place(s).at.z) * std::cos(reference.angle);
    return {std::isfinite(slope) ? slope : 0};
}

void add_slopes_at_elements(SlopesAlong& slopes, const Grid& grid, const std::vector<double>& heights) {
    if (heights.size() != grid.size()) return;  // With one height per row, the rail is uniform along x.
    slopes.at_elements.clear();
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix)
            slopes.at_elements.push_back(
                slope_between(heights, static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx), ix, grid));
}

}  // namespace contactd::geometry

#include "entering_particles.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {

EnteringParticles entering_particles(const Grid& grid, std::span<const double> pressure, std::array<double, 2> step) {
    constexpr double rounding = 1e-9;
    // A particle is traced by whole elements along the axis in which its step crosses more of them.
    const double along = step[0] / grid.dx, across = step[1] / grid.dy;
    const double elements = std::max(std::abs(along), std::abs(across));
    if (!(elements > 1 + rounding)) return {};
    const auto upstream = [&](int place, double way, int ahead, int count) {
        return std::clamp(place + static_cast<int>(std::lround(ahead * way / elements)), -1, count);
    };
    const auto element = [&](int ix, int iy) {
        return static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
    };
    const auto touches = [&](int ix, int iy) {
        return ix >= 0 && ix < grid.nx && iy >= 0 && iy < grid.ny && pressure[element(ix, iy)] > 0;
    };
    EnteringParticles found{std::vector<double>(grid.size(), 1), std::vector<std::size_t>(grid.size())};
    bool any = false;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            if (!touches(ix, iy)) continue;
            int ahead = 0, x = ix, y = iy;
            do {
                ++ahead;
                x = upstream(ix, along, ahead, grid.nx);
                y = upstream(iy, across, ahead, grid.ny);
            } while (ahead < elements && touches(x, y));
            if (!(ahead < elements)) continue;
            found.part[element(ix, iy)] = ahead / elements;
            found.from[element(ix, iy)] = element(std::clamp(x, 0, grid.nx - 1), std::clamp(y, 0, grid.ny - 1));
            any = true;
        }
    if (!any) return {};
    return found;
}

}  // namespace contactd

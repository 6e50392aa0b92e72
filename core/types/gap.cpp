#include "contactd/gap.hpp"

namespace contactd {

std::vector<double> sampled(const Paraboloid& paraboloid, const Grid& grid) {
    std::vector<double> h;
    h.reserve(grid.size());
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const double x = grid.x(ix), y = grid.y(iy);
            h.push_back(x * x / (2 * paraboloid.Rx) + y * y / (2 * paraboloid.Ry));
        }
    return h;
}

}  // namespace contactd

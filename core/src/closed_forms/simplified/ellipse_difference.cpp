#include "ellipse_difference.hpp"

#include <cstddef>

#include "closed_forms/semi_ellipsoid.hpp"

namespace contactd {

EllipticFriction ellipse_difference(const Grid& grid, const EllipticContact& contact, double mu, const Pair& direction,
                                    double k, const RollingFrame* rolling) {
    EllipticFriction result;
    result.traction_x.resize(grid.size());
    result.traction_y.resize(grid.size());
    result.element_division.assign(grid.size(), ElementState::exterior);
    if (contact.empty()) return result;
    const double ahead = rolling ? (1 - k) * rolling->axes.a : 0;
    const double xc = rolling ? rolling->x_of(ahead, 0) : 0, yc = rolling ? rolling->y_of(ahead, 0) : 0;
    const SemiEllipsoid outer{contact.axes}, inner{contact.axes, k, xc, yc};
    const double bound = mu * contact.pmax();
    const auto columns = static_cast<std::size_t>(grid.nx);
    std::vector<double> whole(columns), adhering(columns);
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy) {
        heights_along(grid, iy, outer, whole);
        heights_along(grid, iy, inner, adhering);
        for (std::size_t ix = 0; ix < columns; ++ix, ++i) {
            if (!(whole[ix] > 0)) continue;
            const double size = bound * (whole[ix] - adhering[ix]);
            result.traction_x[i] = size * direction[0];
            result.traction_y[i] = size * direction[1];
            result.element_division[i] = adhering[ix] > 0 ? ElementState::adhesion : ElementState::slip;
        }
    }
    const int n = contact.force_power();
    const double force = mu * contact.Fn, share = times_power(k, k, n - 1);
    result.Fx = force * (1 - share) * direction[0];
    result.Fy = force * (1 - share) * direction[1];
    result.Mz = times_power(-force, k, n) * (xc * direction[1] - yc * direction[0]);
    result.adhesion_area = times_power(k, k, n - 2) * contact.area();
    result.slip_area = contact.area() - result.adhesion_area;
    return result;
}

}  // namespace contactd

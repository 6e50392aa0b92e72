#include "ellipse_difference.hpp"

#include <algorithm>
#include <cmath>

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
    const double a = contact.axes.a, b = contact.axes.b, bound = mu * contact.pmax();
    const auto inside = [&](double x, double y) { return 1 - x * x / (a * a) - y * y / (b * b); };
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const double outer = inside(grid.x(ix), grid.y(iy));
            if (outer <= 0) continue;
            // Of the smaller ellipse k^2 - x^2/a^2 - y^2/b^2 about its centre: k sqrt(1 - ...) is its square root.
            const double inner = inside(grid.x(ix) - xc, grid.y(iy) - yc) - (1 - k * k);
            const double size = bound * (std::sqrt(outer) - std::sqrt(std::max(0.0, inner)));
            result.traction_x[i] = size * direction[0];
            result.traction_y[i] = size * direction[1];
            result.element_division[i] = k > 0 && inner > 0 ? ElementState::adhesion : ElementState::slip;
        }
    const double force = mu * contact.Fn;
    result.Fx = force * (1 - k * k * k) * direction[0];
    result.Fy = force * (1 - k * k * k) * direction[1];
    result.Mz = -force * k * k * k * (xc * direction[1] - yc * direction[0]);
    result.adhesion_area = k * k * contact.area();
    result.slip_area = contact.area() - result.adhesion_area;
    return result;
}

}  // namespace contactd

#include "elliptic_contact.hpp"

#include <cmath>
#include <numbers>

namespace contactd {

Material combined_material(const MaterialPair& bodies) {
    const double compliance = 0.5 * (1 / bodies.upper.G + 1 / bodies.lower.G);  // zero of a rigid one
    const double nu = 0.5 * (bodies.upper.nu / bodies.upper.G + bodies.lower.nu / bodies.lower.G) / compliance;
    return {1 / compliance, nu};
}

double EllipticContact::area() const {
    return std::numbers::pi * axes.a * axes.b;
}

double EllipticContact::pmax() const {
    return empty() ? 0 : 1.5 * Fn / area();
}

std::vector<double> hertz_pressure(const Grid& grid, const EllipticContact& contact) {
    std::vector<double> pressure(grid.size());
    if (contact.empty()) return pressure;
    const double p0 = contact.pmax();
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const double x = grid.x(ix) / contact.axes.a, y = grid.y(iy) / contact.axes.b;
            pressure[i] = p0 * std::sqrt(std::max(0.0, 1 - x * x - y * y));
        }
    return pressure;
}

}  // namespace contactd

#include "elliptic_contact.hpp"

#include <algorithm>
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

std::vector<double> hertz_pressure(const Grid& grid, const SemiAxes& axes, double pmax) {
    std::vector<double> pressure(grid.size());
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const double x = grid.x(ix) / axes.a, y = grid.y(iy) / axes.b;
            pressure[i] = pmax * std::sqrt(std::max(0.0, 1 - x * x - y * y));
        }
    return pressure;
}

std::vector<double> hertz_pressure(const Grid& grid, const EllipticContact& contact) {
    if (contact.empty()) return std::vector<double>(grid.size());
    return hertz_pressure(grid, contact.axes, contact.pmax());
}

}  // namespace contactd

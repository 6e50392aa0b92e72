#include "elliptic_contact.hpp"

#include <cstddef>
#include <numbers>

#include "semi_ellipsoid.hpp"

namespace contactd {

Material combined_material(const MaterialPair& bodies) {
    const double compliance = 0.5 * (1 / bodies.upper.G + 1 / bodies.lower.G);  // zero for a rigid body
    const double nu = 0.5 * (bodies.upper.nu / bodies.upper.G + bodies.lower.nu / bodies.lower.G) / compliance;
    return {1 / compliance, nu};
}

double EllipticContact::area() const {
    return is_strip() ? 2 * axes.a * length : std::numbers::pi * axes.a * axes.b;
}

double EllipticContact::pmax() const {
    if (empty()) return 0;
    return (is_strip() ? 4 / std::numbers::pi : 1.5) * Fn / area();
}

std::vector<double> hertz_pressure(const Grid& grid, const SemiAxes& axes, double pmax) {
    std::vector<double> pressure(grid.size());
    const auto columns = static_cast<std::size_t>(grid.nx);
    for (int iy = 0; iy < grid.ny; ++iy)
        heights_along(grid, iy, {axes}, {&pressure[static_cast<std::size_t>(iy) * columns], columns});
    for (double& p : pressure) p *= pmax;
    return pressure;
}

std::vector<double> hertz_pressure(const Grid& grid, const EllipticContact& contact) {
    if (contact.empty()) return std::vector<double>(grid.size());
    return hertz_pressure(grid, contact.axes, contact.pmax());
}

}  // namespace contactd

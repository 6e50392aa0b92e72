#include "rolling.hpp"

#include <cmath>

#include "contact/support/solver_support.hpp"

namespace contactd {

RigidSlip rigid_slip(const Grid& grid, const Rolling& rolling, double dq) {
    const double ahead = rolling.spin_offset * dq;
    const double ahead_x = ahead * std::cos(rolling.chi), ahead_y = ahead * std::sin(rolling.chi);
    RigidSlip result;
    result.x.reserve(grid.size());
    result.y.reserve(grid.size());
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            result.x.push_back(dq * (rolling.xi - rolling.phi * (grid.y(iy) + ahead_y)));
            result.y.push_back(dq * (rolling.eta + rolling.phi * (grid.x(ix) + ahead_x)));
        }
    return result;
}

RigidSlip rigid_slip(const Grid& grid, const Shift& shift) {
    return rigid_slip(
        grid, Rolling{.xi = shift.rigid_shift.x, .eta = shift.rigid_shift.y, .phi = shift.rotation, .spin_offset = 0},
        1);
}

TangentialForces tangential_forces(const Grid& grid, std::span<const double> traction_x,
                                   std::span<const double> traction_y) {
    require_size(traction_x, grid.size(), "traction_x");
    require_size(traction_y, grid.size(), "traction_y");
    TangentialForces sum;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const std::size_t i =
                static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
            sum.Fx += traction_x[i];
            sum.Fy += traction_y[i];
            sum.Mz += grid.x(ix) * traction_y[i] - grid.y(iy) * traction_x[i];
        }
    const double area = grid.element_area();
    return {sum.Fx * area, sum.Fy * area, sum.Mz * area};
}

}  // namespace contactd

#include "curved_columns.hpp"

#include <cmath>

namespace contactd {

std::vector<double> facing(const ContactColumns& columns, const Grid& grid) {
    std::vector<double> result;
    result.reserve(grid.size());
    for (const ColumnFrame& frame : columns.frames)
        result.insert(result.end(), static_cast<std::size_t>(grid.nx), std::cos(frame.angle - columns.direction));
    return result;
}

Grid row_across(const ContactColumns& columns, const Grid& grid, int iy) {
    const ColumnFrame& frame = columns.frames[static_cast<std::size_t>(iy)];
    const double y = frame.y - columns.origin.y, z = frame.z - columns.origin.z;
    const double across = y * std::cos(columns.direction) - z * std::sin(columns.direction);
    return {grid.nx, 1, grid.dx, grid.dy, grid.x0, across - 0.5 * grid.dy};
}

void sum_forces(const ContactColumns& columns, const Grid& grid, ContactSolution& solution) {
    Forces& forces = solution.forces;
    forces = {};
    Resultant sum;
    for (int iy = 0; iy < grid.ny; ++iy) {
        const ColumnFrame& frame = columns.frames[static_cast<std::size_t>(iy)];
        const double cosine = std::cos(frame.angle - columns.direction);
        const double across = row_across(columns, grid, iy).y(0);
        const double y = frame.y - columns.origin.y, z = frame.z - columns.origin.z;
        const double sine_n = std::sin(frame.angle), cosine_n = std::cos(frame.angle);
        for (int ix = 0; ix < grid.nx; ++ix) {
            const std::size_t i =
                static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
            const double p = solution.pressure[i], px = solution.traction_x[i], py = solution.traction_y[i];
            const double x = grid.x(ix);
            forces.Fn += p * cosine;
            forces.Fx += px;
            forces.Fy += py * cosine;
            forces.Mz += x * py * cosine - across * px;
            const double fy = p * sine_n + py * cosine_n, fz = p * cosine_n - py * sine_n;
            sum.Fx += px;
            sum.Fy += fy;
            sum.Fz += fz;
            sum.Mx += y * fz - z * fy;
            sum.My += z * px - x * fz;
            sum.Mz += x * fy - y * px;
        }
    }
    const double area = grid.element_area();
    for (double* value :
         {&forces.Fn, &forces.Fx, &forces.Fy, &forces.Mz, &sum.Fx, &sum.Fy, &sum.Fz, &sum.Mx, &sum.My, &sum.Mz})
        *value *= area;
    solution.resultant = sum;
}

}  // namespace contactd

#include "curved_strips.hpp"

#include <cmath>

namespace contactd {

std::vector<double> facing(const ContactColumns& strips, const Grid& grid) {
    std::vector<double> result;
    result.reserve(grid.size());
    for (const StripFrame& frame : strips.frames)
        result.insert(result.end(), static_cast<std::size_t>(grid.nx), std::cos(frame.angle - strips.direction));
    return result;
}

Grid row_across(const ContactColumns& strips, const Grid& grid, int iy) {
    const StripFrame& frame = strips.frames[static_cast<std::size_t>(iy)];
    const double y = frame.y - strips.origin.y, z = frame.z - strips.origin.z;
    const double across = y * std::cos(strips.direction) - z * std::sin(strips.direction);
    return {grid.nx, 1, grid.dx, grid.dy, grid.x0, across - 0.5 * grid.dy};
}

void sum_forces(const ContactColumns& strips, const Grid& grid, ContactSolution& solution) {
    Forces& forces = solution.forces;
    forces = {};
    Resultant sum;
    for (int iy = 0; iy < grid.ny; ++iy) {
        const StripFrame& frame = strips.frames[static_cast<std::size_t>(iy)];
        const double cosine = std::cos(frame.angle - strips.direction);
        const double across = row_across(strips, grid, iy).y(0);
        const double y = frame.y - strips.origin.y, z = frame.z - strips.origin.z;
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

#include "normal.hpp"

#include "contact/support/solver_support.hpp"
#include "normal_solver.hpp"

namespace contactd {

NormalSolution solve_normal(const InfluenceOperator& influence, std::span<const double> gap,
                            const SolverSettings& settings, std::span<const double> initial, Observer& observer,
                            const PressureEstimate& closed_form) {
    return NormalSolver(influence).solve({gap, {}, settings}, initial, closed_form, observer);
}

NormalSolution solve_normal_force(const InfluenceOperator& influence, std::span<const double> undeformed_distance,
                                  double pressure_sum, const SolverSettings& settings, std::span<const double> initial,
                                  Observer& observer, const PressureEstimate& closed_form) {
    return NormalSolver(influence).solve({undeformed_distance, pressure_sum, settings}, initial, closed_form, observer);
}

int border_elements(const Grid& grid, std::span<const double> pressure, const BorderRows& rows) {
    require_size(pressure, grid.size(), "pressure");
    int count = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const bool border =
                ix == 0 || ix == grid.nx - 1 || (rows.first && iy == 0) || (rows.last && iy == grid.ny - 1);
            count += border && pressure[static_cast<std::size_t>(iy * grid.nx + ix)] > 0;
        }
    return count;
}

}  // namespace contactd

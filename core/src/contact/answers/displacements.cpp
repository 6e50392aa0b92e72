#include "contact/answers/displacements.hpp"

#include <cstddef>
#include <vector>

namespace contactd {

void find_displacements(const Grid& grid, const InfluenceOperator& influence, ContactSolution& solution) {
    const std::size_t n = grid.size();
    for (auto* values : {&solution.displacement_x, &solution.displacement_y, &solution.displacement_z})
        values->assign(n, 0);
    std::vector<double> x(n), y(n), z(n);
    influence.normal(solution.pressure, solution.displacement_z);
    influence.tangential(solution.traction_x, solution.traction_y, solution.displacement_x, solution.displacement_y);
    influence.normal_of_tangential(solution.traction_x, solution.traction_y, z);
    influence.tangential_of_normal(solution.pressure, x, y);
    double energy = 0;
    for (std::size_t i = 0; i < n; ++i) {
        solution.displacement_x[i] += x[i];
        solution.displacement_y[i] += y[i];
        solution.displacement_z[i] += z[i];
        energy += solution.traction_x[i] * solution.displacement_x[i] +
                  solution.traction_y[i] * solution.displacement_y[i] +
                  solution.pressure[i] * solution.displacement_z[i];
    }
    solution.elastic_energy = 0.5 * energy * grid.element_area();
}

}  // namespace contactd

#include "output_weights.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

using Values = std::vector<double>;

void add_forces(const Cotangents& output, const Grid& grid, OutputWeights& weights) {
    const double area = grid.element_area();
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            weights.pressure[i] += area * output.Fn;
            weights.traction.x[i] += area * (output.Fx - grid.y(iy) * output.Mz);
            weights.traction.y[i] += area * (output.Fy + grid.x(ix) * output.Mz);
        }
}

// The work is -sum q.s dx dy over the elements that slip; `unit` converts it to the power of rolling.
void add_losses(const Cotangents& output, const Grid& grid, double unit, const ContactSolution& solution,
                OutputWeights& weights) {
    const double whole = output.frictional_work + output.frictional_power;  // A problem has one of them.
    if (whole == 0 && output.loss_of_rows.empty()) return;
    for (std::size_t i = 0; i < solution.slip_x.size(); ++i) {
        if (solution.element_division[i] != ElementState::slip) continue;
        const std::size_t row = i / static_cast<std::size_t>(grid.nx);
        const double factor = unit * (whole + (output.loss_of_rows.empty() ? 0 : output.loss_of_rows[row]));
        weights.traction.x[i] -= factor * solution.slip_x[i];
        weights.traction.y[i] -= factor * solution.slip_y[i];
        weights.slip.x[i] -= factor * solution.traction_x[i];
        weights.slip.y[i] -= factor * solution.traction_y[i];
    }
}

// The sums are relative to the largest pressure, whose powers may overflow.
void add_norm(const Cotangents& output, double area, const ContactSolution& solution, Values& weights) {
    const double order = output.norm_order, largest = solution.pmax;
    if (output.pressure_norm == 0 || !(largest > 0)) return;
    double sum = 0;
    for (const double p : solution.pressure) sum += std::pow(p / largest, order) * area;
    const double factor = output.pressure_norm * std::pow(sum, 1 / order - 1) * area;
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (solution.pressure[i] > 0) weights[i] += factor * std::pow(solution.pressure[i] / largest, order - 1);
}

void add_array(const Values& from, double factor, Values& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] += factor * from[i];
}

}  // namespace

OutputWeights weights_of(const Cotangents& output, const Grid& grid, const ContactSolution& solution, double unit) {
    OutputWeights weights(grid.size());
    const double area = grid.element_area();
    add_forces(output, grid, weights);
    const auto* rolling = solution.motion ? std::get_if<Rolling>(&*solution.motion) : nullptr;
    add_losses(output, grid, area * (rolling != nullptr ? rolling->velocity / unit : 1), solution, weights);
    if (output.pmax != 0)
        weights.pressure[static_cast<std::size_t>(std::ranges::max_element(solution.pressure) -
                                                  solution.pressure.begin())] += output.pmax;
    add_norm(output, area, solution, weights.pressure);
    add_array(output.pressure, 1, weights.pressure);
    add_array(output.traction_x, 1, weights.traction.x);
    add_array(output.traction_y, 1, weights.traction.y);
    add_array(output.slip_x, 1 / unit, weights.slip.x);
    add_array(output.slip_y, 1 / unit, weights.slip.y);
    weights.approach = output.approach;
    weights.along_x = rolling != nullptr ? output.xi : output.rigid_shift.x;
    weights.along_y = rolling != nullptr ? output.eta : output.rigid_shift.y;
    return weights;
}

std::string tie_warning(const Cotangents& output, const ContactSolution& solution) {
    constexpr double nearly = 1e-6;
    if (output.pmax == 0) return {};
    const auto ties =
        std::ranges::count_if(solution.pressure, [&](double p) { return p > 0 && p >= (1 - nearly) * solution.pmax; });
    if (ties < 2) return {};
    return "The largest pressure is that of " + std::to_string(ties) +
           " elements, so pmax has no gradient; that of the first one is returned. Use pressure_norm instead of pmax.";
}

}  // namespace contactd

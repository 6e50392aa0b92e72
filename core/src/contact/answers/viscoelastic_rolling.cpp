#include "viscoelastic_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "closed_forms/undeformed_distance.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double shortest_length = 0.5;  // length of creep, V tau, in elements
constexpr double longest_length = 100;   // length of creep in lengths of the contact

const Rolling* rolling_of(const ContactProblem& problem) {
    return problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
}

/// Returns central differences along x, which are one-sided at both ends of a row.
std::vector<double> slope_along_x(const Grid& grid, const std::vector<double>& values) {
    std::vector<double> slope(values.size());
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const int before = std::max(ix - 1, 0), after = std::min(ix + 1, grid.nx - 1);
            const auto at = [&](int k) { return static_cast<std::size_t>(iy * grid.nx + k); };
            if (after > before) slope[at(ix)] = (values[at(after)] - values[at(before)]) / ((after - before) * grid.dx);
        }
    return slope;
}

double length_of_contact(const Grid& grid, const std::vector<double>& pressure) {
    int first = grid.nx, last = -1;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            if (!(pressure[static_cast<std::size_t>(iy * grid.nx + ix)] > 0)) continue;
            first = std::min(first, ix);
            last = std::max(last, ix);
        }
    return std::max(last - first + 1, 0) * grid.dx;
}

}  // namespace

std::optional<RollingResistance> rolling_resistance(const ContactProblem& problem, const InfluenceOperator& influence,
                                                    const ContactSolution& solution) {
    const Rolling* rolling = rolling_of(problem);
    if (rolling == nullptr || solution.elements.contact == 0) return {};
    const Grid& grid = problem.grid;
    const std::size_t n = grid.size();
    std::vector<double> uz(n), of_tractions(n);
    influence.normal(solution.pressure, uz);
    influence.normal_of_tangential(solution.traction_x, solution.traction_y, of_tractions);
    for (std::size_t i = 0; i < n; ++i) uz[i] += of_tractions[i];
    const std::vector<double> of_gap = slope_along_x(grid, undeformed_distance(problem)),
                              of_surface = slope_along_x(grid, uz);
    double rise = 0, fall = 0, scale = 0, moment = 0, sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double p = solution.pressure[i];
        rise += p * of_gap[i];
        fall -= p * of_surface[i];
        scale += p * std::abs(of_gap[i]);
        moment += p * (grid.x0 + (static_cast<double>(i % static_cast<std::size_t>(grid.nx)) + 0.5) * grid.dx);
        sum += p;
    }
    const double area = grid.element_area(), sign = std::cos(rolling->chi) > 0 ? 1 : -1;
    RollingResistance resistance;
    resistance.force = sign * rise * area;
    resistance.power = resistance.force * rolling->velocity;
    resistance.centre_of_pressure = moment / sum;
    resistance.moment = moment * area;
    resistance.defect = scale > 0 ? std::abs(rise - fall) / scale : 0;
    return resistance;
}

std::vector<std::string> creep_warnings(const ContactProblem& problem, const ContactSolution& solution) {
    std::vector<std::string> warnings;
    const Rolling* rolling = rolling_of(problem);
    if (rolling == nullptr || problem.bodies.pair || solution.elements.contact == 0) return warnings;
    const auto creeps = [](const Body& body) {
        return body.viscoelastic && body.viscoelastic->f > 0 && body.viscoelastic->tau > 0;
    };
    if (rolling->velocity == 1 && (creeps(problem.bodies.upper) || creeps(problem.bodies.lower)))
        warnings.push_back(
            "friction.rolling.velocity is 1 mm/s, the default, but the response of viscoelastic bodies depends on it. "
            "Give the velocity of rolling.");
    const double contact = length_of_contact(problem.grid, solution.pressure);
    for (const auto& [body, name] : {std::pair(&problem.bodies.upper, "bodies.upper.viscoelastic.tau"),
                                     std::pair(&problem.bodies.lower, "bodies.lower.viscoelastic.tau")}) {
        if (!creeps(*body)) continue;
        const double l = rolling->velocity * body->viscoelastic->tau;
        const std::string rolls = std::string(name) + " is " + number_text(body->viscoelastic->tau) +
                                  " s, in which the bodies roll " + short_text(l) + " mm: ";
        if (l < shortest_length * problem.grid.dx)
            warnings.push_back(rolls +
                               "less than half an element. An elastic body of modulus G/(1 + f), which is tau = 0, has "
                               "the same solution.");
        else if (l > longest_length * contact)
            warnings.push_back(rolls +
                               "more than a hundred times the length of the contact. An elastic body of modulus G, "
                               "which is f = 0, has the same solution.");
    }
    return warnings;
}

}  // namespace contactd

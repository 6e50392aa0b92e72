// Provides problems for the contact tests, and dense sums as an independent check of operators and solutions.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "closed_forms/undeformed_distance.hpp"
#include "contactd/contact.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/solve_contact.hpp"
#include "pair_operators.hpp"

namespace contactd::test {

using Values = std::vector<double>;

inline IcTable half_space_pair(const Grid& grid, const Material& material, LoadShape load_shape = LoadShape::constant) {
    IcSpec spec;
    spec.load_shape = load_shape;
    spec.material = material;
    spec.dx = grid.dx;
    spec.dy = grid.dy;
    spec.nx = grid.nx;
    spec.ny = grid.ny;
    const IcTable body = half_space_table(spec);
    return pair_of(body, body);
}

inline std::size_t at(const Grid& grid, int ix, int iy) {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
}

/// Returns the table of half-spaces; a rigid body has none.
inline IcTable body_table(const Grid& grid, const Material& material, const Ics& ics = {}) {
    if (material.is_rigid()) return IcTable(grid.nx, grid.ny);
    return half_space_table({ics, material, grid.dx, grid.dy, grid.nx, grid.ny});
}

/// Returns the table of the problem's bodies, as half-spaces regardless of their shape.
inline IcTable pair_table(const ContactProblem& problem) {
    const auto table = [&](const Body& body) {
        Ics ics = std::get<Ics>(body.ics);
        ics.source = IcSource::analytic;
        ics.body = BodyShape::half_space;
        return body_table(problem.grid, body.material, ics);
    };
    const Bodies bodies = without_instant_creep(problem.bodies);
    return pair_of(table(bodies.upper), table(bodies.lower));
}

inline ContactSolution solve_half_spaces(const ContactProblem& problem) {
    Observer observer;
    return solve_contact(problem, operators_of(problem, pair_table(problem)), observer);
}

/// u_i = A[i,j] p_j, element by element.
inline Values dense_product(const IcTable& table, Axis i, Axis j, int nx, int ny, const Values& p) {
    Values u(p.size());
    const int n = nx * ny;
    for (int to = 0; to < n; ++to)
        for (int from = 0; from < n; ++from)
            u[static_cast<std::size_t>(to)] +=
                table.at(i, j, to % nx - from % nx, to / nx - from / nx) * p[static_cast<std::size_t>(from)];
    return u;
}

inline Values sum(Values a, const Values& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
}

inline Values random_values(std::size_t n, unsigned seed, double low = -1, double high = 1) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(low, high);
    Values values(n);
    for (double& value : values) value = uniform(generator);
    return values;
}

inline double largest(const Values& values) {
    double result = 0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
}

/// Creates the Cattaneo problem of the paper's section 4 on n x n elements.
inline ContactProblem cattaneo_problem(int n) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 2.4 / n, 2.4 / n);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    problem.friction = FrictionLaw{{0.4}};
    problem.motion = Shift{{0.00817, 0}};
    return problem;
}

}  // namespace contactd::test

// Creates rolling problems for tests, and checks the friction law with displacements from dense sums.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contact/friction/steady_rolling.hpp"
#include "contact_cases.hpp"
#include "influence/shifted_table.hpp"

namespace contactd::test {

/// Creates two half-spaces of one material; the bound is mu times a Hertzian ellipse that fills the window.
struct RollingCase {
    Grid grid;
    double dq, step_x, step_y;
    IcTable pair;
    ShiftedTable increment_table;
    ContactInfluence operators;
    const InfluenceOperator& influence;
    const StepOperator& increment;
    RollingBodies bodies;
    Values bound;
    Rolling rolling;

    RollingCase(const Grid& grid_, const Material& material, double largest_bound, double chi, double dq_)
        : grid(grid_),
          dq(dq_),
          step_x(dq * std::cos(chi)),
          step_y(dq * std::sin(chi)),
          pair(half_space_pair(grid, material)),
          increment_table(change_over_step(
              pair, shifted_half_spaces({{material, material}, LoadShape::constant}, grid, step_x, step_y))),
          operators(operators_of(problem(material, chi), pair)),
          influence(*operators.current),
          increment(*operators.increment),
          bodies{influence, increment, grid, step_x, step_y} {
        rolling.chi = chi;
        for (int iy = 0; iy < grid.ny; ++iy)
            for (int ix = 0; ix < grid.nx; ++ix) {
                const double x = 2 * grid.x(ix) / (grid.nx * grid.dx), y = 2 * grid.y(iy) / (grid.ny * grid.dy);
                bound.push_back(largest_bound * std::sqrt(std::max(1 - x * x - y * y, 0.0)));
            }
    }
    RollingCase(const RollingCase&) = delete;

    ContactProblem problem(const Material& material, double chi) const {
        ContactProblem problem;
        problem.grid = grid;
        problem.bodies = {{material}, {material}};
        problem.friction = FrictionLaw{{0.3}};
        problem.motion = Rolling{.chi = chi, .dq = dq};
        return problem;
    }

    void set(double xi, double eta, double phi) {
        rolling.xi = xi;
        rolling.eta = eta;
        rolling.phi = phi;
    }

    RollingSolution steady(const SolverSettings& settings = {}, const Values& initial_x = {},
                           const Values& initial_y = {}) const {
        Observer observer;
        const RigidSlip w = rigid_slip(grid, rolling, dq);
        return solve_steady_rolling(bodies, bound, w.x, w.y, settings, initial_x, initial_y, observer);
    }

    TangentialForces forces(const TangentialSolution& solution) const {
        return tangential_forces(grid, solution.traction_x, solution.traction_y);
    }

    /// Returns C[i,x] px + C[i,y] py, element by element.
    Values dense_increment(Axis i, const Values& px, const Values& py) const {
        Values u(grid.size());
        const int n = static_cast<int>(grid.size());
        for (int to = 0; to < n; ++to)
            for (int from = 0; from < n; ++from) {
                const int k = to % grid.nx - from % grid.nx, l = to / grid.nx - from / grid.nx;
                const auto j = static_cast<std::size_t>(from);
                u[static_cast<std::size_t>(to)] +=
                    increment_table(i, Axis::x, k, l) * px[j] + increment_table(i, Axis::y, k, l) * py[j];
            }
        return u;
    }
};

struct RollingCounts {
    int adhesion = 0, slip = 0;
};

inline RollingCounts count(const TangentialSolution& solution) {
    RollingCounts counts;
    for (const ElementState state : solution.element_division) {
        counts.adhesion += state == ElementState::adhesion;
        counts.slip += state == ElementState::slip;
    }
    return counts;
}

/// Checks Coulomb's law in the steady state, element by element. `accuracy` is the error of slip over the largest rigid
/// slip.
inline void check_steady_law(const RollingCase& rolling, const RollingSolution& solution, double accuracy) {
    using Catch::Matchers::WithinAbs;
    using Catch::Matchers::WithinRel;
    REQUIRE(solution.evidence.converged);
    const auto &px = solution.traction_x, &py = solution.traction_y;
    const RigidSlip w = rigid_slip(rolling.grid, rolling.rolling, rolling.dq);
    const Values sx = sum(rolling.dense_increment(Axis::x, px, py), w.x);
    const Values sy = sum(rolling.dense_increment(Axis::y, px, py), w.y);
    const double unit = std::max(largest(w.x), largest(w.y)) * accuracy;
    for (std::size_t i = 0; i < px.size(); ++i) {
        const double p = std::hypot(px[i], py[i]), g = rolling.bound[i];
        CAPTURE(i, p, g, sx[i], sy[i]);
        if (solution.element_division[i] == ElementState::exterior) {
            CHECK(g == 0);
            CHECK(p == 0);
            CHECK(std::hypot(solution.slip_x[i], solution.slip_y[i]) == 0);
            continue;
        }
        CHECK_THAT(solution.slip_x[i], WithinAbs(sx[i], unit));
        CHECK_THAT(solution.slip_y[i], WithinAbs(sy[i], unit));
        if (solution.element_division[i] == ElementState::adhesion) {
            CHECK(p <= g * (1 + 1e-8));
            CHECK_THAT(std::hypot(sx[i], sy[i]), WithinAbs(0, unit));
        } else {
            CHECK_THAT(p, WithinRel(g, 1e-12));
            CHECK_THAT((sx[i] * py[i] - sy[i] * px[i]) / g, WithinAbs(0, unit));
            CHECK((sx[i] * px[i] + sy[i] * py[i]) / g <= unit);
        }
    }
}

}  // namespace contactd::test

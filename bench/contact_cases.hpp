// Defines the two problems shared by the benchmarks of the contact solvers, and the conversion of times to products A
// p.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "closed_forms/hertz.hpp"
#include "contact/friction/steady_rolling.hpp"
#include "contact/normal/normal.hpp"
#include "contact/tangential/tangential.hpp"
#include "contactd/contact.hpp"
#include "contactd/half_space.hpp"
#include "operators/convolution.hpp"
#include "operators/shifted_operator.hpp"

namespace contactd::bench {

using Values = std::vector<double>;

// Returns processor time, because a busy machine would distort the wall-clock ratio of a solve to a product.
inline double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Sets counter A_p, the median time of a solve over that of a product with A_zz on the same grid. Products are timed
/// between the solves, so that other work affects both equally. `solve` returns the evidence of the solver, or
/// nothing.
template <class Solve>
void count_in_products(benchmark::State& state, const InfluenceOperator& influence, const Solve& solve) {
    constexpr double enough = 1e-3;  // seconds of products per measurement
    const Values p(influence.size(), 1.0);
    Values u(p.size());
    influence.normal(p, u);
    SolverEvidence evidence = solve();  // creates coarser grids, boxes and plans
    std::vector<double> solves, products;
    for (auto _ : state) {
        double start = processor_seconds();
        evidence = solve();
        solves.push_back(processor_seconds() - start);
        state.PauseTiming();
        int repeats = 0;
        start = processor_seconds();
        double seconds = 0;
        do {
            for (int i = 0; i < 4; ++i) influence.normal(p, u);
            repeats += 4;
            seconds = processor_seconds() - start;
        } while (seconds < enough);
        products.push_back(seconds / repeats);
        state.ResumeTiming();
    }
    state.counters["A_p"] = median(solves) / median(products);
    state.counters["solver_iterations"] = evidence.iterations;
    if (!evidence.converged) state.SkipWithError("the solver did not converge");
}

inline SolverEvidence evidence_of(const ContactSolution& solution) {
    SolverEvidence evidence = solution.evidence.tangential.value_or(solution.evidence.normal);
    evidence.converged = solution.converged();
    return evidence;
}

inline IcTable half_space_of(const Grid& grid, const Material& material) {
    IcSpec spec;
    spec.material = material;
    spec.dx = grid.dx;
    spec.dy = grid.dy;
    spec.nx = grid.nx;
    spec.ny = grid.ny;
    return half_space_table(spec);
}

inline IcTable pair_table(const Grid& grid, const Material& material) {
    const IcTable body = half_space_of(grid, material);
    return pair_of(body, body);
}

inline IcTable pair_table(const ContactProblem& problem) {
    const auto& [upper, lower] = problem.bodies.materials();
    if (upper == lower) return pair_table(problem.grid, upper);
    return pair_of(half_space_of(problem.grid, upper), half_space_of(problem.grid, lower));
}

/// Returns the paper's Cattaneo problem (section 4): a sphere at a prescribed approach, shifted.
struct Cattaneo {
    Grid grid;
    ConvolutionOperator influence;
    Values gap, bound;
    mutable Observer observer;

    explicit Cattaneo(int n)
        : grid(Grid::of_elements(n, n, 2.4 / n, 2.4 / n)),
          influence(pair_table(grid, {200, 0.42}), n, n),
          gap(sampled(Paraboloid{50, 50}, grid)) {
        for (double& h : gap) h -= 0.02;
        bound = normal().pressure;
        for (double& g : bound) g *= 0.4;
    }

    NormalSolution normal(const Values& initial = {}) const {
        return solve_normal(influence, gap, {}, initial, observer);
    }
    NormalSolution normal_force() const {
        return solve_normal_force(influence, gap, 9.1954 / grid.element_area(), {}, {}, observer);
    }
    /// Holds the rigid shift (mm) and rotation (rad).
    TangentialSolution tangential(double x = 0.00817, double y = 0, double rotation = 0,
                                  const TangentialSolution& last = {}) const {
        const RigidSlip w = rigid_slip(grid, Shift{{x, y}, rotation});
        return solve_tangential(influence, bound, w.x, w.y, {}, last.traction_x, last.traction_y, observer);
    }
};

/// Holds steady rolling of the reference values: semi-axes 6 x 4 mm, 50 kN, window 1.1 times the ellipse's box, mu =
/// 0.3, creepages 0.002, 0.001 and spin 1e-4 rad/mm, each times a factor.
struct Elliptic {
    static constexpr Material steel{82000, 0.28};
    static constexpr double Fn = 50000;

    Grid grid;
    IcTable pair;
    ConvolutionOperator influence;
    ShiftedOperator change;
    RollingBodies bodies;
    Values bound;
    mutable Observer observer;

    explicit Elliptic(int n)
        : grid(Grid::of_elements(n, n, 13.2 / n, 8.8 / n)),
          pair(pair_table(grid, steel)),
          influence(pair, n, n),
          change(change_over_step(pair, shifted_half_spaces({{steel, steel}, LoadShape::constant}, grid, grid.dx, 0))),
          bodies{influence, change, grid, grid.dx, 0} {
        const Values distance = sampled(radii_of_force({6, 4}, (1 - steel.nu) / steel.G, Fn), grid);
        bound = solve_normal_force(influence, distance, Fn / grid.element_area(), {}, {}, observer).pressure;
        for (double& g : bound) g *= 0.3;
    }

    RigidSlip rigid(double longitudinal = 1, double lateral = 1, double spin = 1) const {
        Rolling rolling;
        rolling.xi = 0.002 * longitudinal;
        rolling.eta = 0.001 * lateral;
        rolling.phi = 1e-4 * spin;
        return rigid_slip(grid, rolling, grid.dx);
    }

    RollingSolution steady(const RigidSlip& w, const RollingSolution& last = {}) const {
        return solve_steady_rolling(bodies, bound, w.x, w.y, {}, last.traction_x, last.traction_y, observer);
    }
    /// Solves one transient step after `last`, with the rigid slip w + (C - A) p.
    TangentialSolution transient(const RigidSlip& w, const RollingSolution& last) const {
        Values x(grid.size()), y(x), rigid_x(x), rigid_y(x);
        influence.tangential(last.traction_x, last.traction_y, x, y);
        change.tangential(last.traction_x, last.traction_y, rigid_x, rigid_y);
        for (std::size_t i = 0; i < x.size(); ++i) {
            rigid_x[i] += w.x[i] - x[i];
            rigid_y[i] += w.y[i] - y[i];
        }
        return solve_tangential(influence, bound, rigid_x, rigid_y, {}, last.traction_x, last.traction_y, observer);
    }
};

}  // namespace contactd::bench

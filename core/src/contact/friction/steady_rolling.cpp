#include "steady_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/support/solver_support.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr int most_rounds = 2;            // rounds of transient and direct steps
constexpr int most_steps = 120;           // of one transient
constexpr double march_tolerance = 1e-4;  // sufficient as a start of the direct iteration

void check(const RollingBodies& bodies) {
    validate(bodies.grid, "grid");
    const double dq = std::hypot(bodies.step_x, bodies.step_y);
    if (!(dq > 0) || !std::isfinite(dq))
        throw InvalidArgument("rolling.dq", "is " + number_text(dq) + "; it must be positive and finite");
    if (bodies.influence.size() != bodies.grid.size() || bodies.increment.size() != bodies.grid.size())
        throw InvalidArgument("grid", "has " + std::to_string(bodies.grid.size()) + " elements; the coefficients are " +
                                          "for " + std::to_string(bodies.influence.size()) + ", and " +
                                          std::to_string(bodies.increment.size()) + " for the change over a step");
}

void check_arrays(std::size_t size, std::span<const double> bound, std::span<const double> rigid_x,
                  std::span<const double> rigid_y, std::span<const double> initial_x,
                  std::span<const double> initial_y) {
    require_size(bound, size, "bound");
    require_size(rigid_x, size, "rigid_x");
    require_size(rigid_y, size, "rigid_y");
    if (!initial_x.empty()) require_size(initial_x, size, "initial.traction_x");
    if (!initial_y.empty()) require_size(initial_y, size, "initial.traction_y");
}

// Returns w - A' p, with A' = A - C.
RigidSlip rigid_slip_after(const FrictionBodies& bodies, const Field& rigid, const Field& p) {
    const std::size_t n = bodies.grid.size();
    RigidSlip result{Values(n), Values(n)};
    Values x(n), y(n);
    bodies.increment->tangential(p.x, p.y, result.x, result.y);
    bodies.influence.tangential(p.x, p.y, x, y);
    for (std::size_t i = 0; i < n; ++i) {
        result.x[i] += rigid.x[i] - x[i];
        result.y[i] += rigid.y[i] - y[i];
    }
    return result;
}

// Makes transient steps from the tractions `p` until they are nearly steady.
void march(const FrictionBodies& bodies, const FrictionTask& task, Field& p, Observer& observer) {
    SilentObserver silent(observer);
    const SolverSettings settings{march_tolerance, 200};
    for (int step = 0; step < most_steps; ++step) {
        const RigidSlip rigid = rigid_slip_after(bodies, task.rigid, p);
        TangentialSolution next =
            solve_tangential(bodies.influence, task.bound, rigid.x, rigid.y, settings, p.x, p.y, silent);
        double change = 0;
        for (std::size_t i = 0; i < p.x.size(); ++i)
            change += std::pow(next.traction_x[i] - p.x[i], 2) + std::pow(next.traction_y[i] - p.y[i], 2);
        p.x = std::move(next.traction_x);
        p.y = std::move(next.traction_y);
        if (change <= march_tolerance * march_tolerance * inner(p, p)) return;
    }
}

Field field_of(std::span<const double> x, std::span<const double> y, std::size_t n) {
    Field field(n);
    std::copy(x.begin(), x.end(), field.x.begin());
    std::copy(y.begin(), y.end(), field.y.begin());
    return field;
}

}  // namespace

RollingSolution march_to_steady_state(const FrictionBodies& bodies, const FrictionTask& task,
                                      const RollingSolution& found, Observer& observer) {
    RollingSolution solution = found;
    if (!bodies.influence.is_symmetric()) return solution;  // TangCG requires symmetric matrices.
    for (int round = 0; round < most_rounds && !solution.evidence.converged; ++round) {
        const SolverEvidence before = solution.evidence;
        const int left = task.settings.max_iterations - before.iterations;
        if (left <= 0) break;
        const Stopwatch stopwatch;
        Field marched = field_of(solution.traction_x, solution.traction_y, task.bound.size());
        march(bodies, task, marched, observer);
        FrictionTask again{task.bound, task.rigid, {}, Pair::Zero(), marched, task.settings, true};
        again.settings.max_iterations = left;
        solution = FrictionSolver(bodies).solve(again, observer);
        solution.evidence.iterations += before.iterations;
        solution.evidence.seconds = before.seconds + stopwatch.seconds();
    }
    return solution;
}

RollingSolution solve_steady_rolling(const RollingBodies& bodies, std::span<const double> bound,
                                     std::span<const double> rigid_x, std::span<const double> rigid_y,
                                     const SolverSettings& settings, std::span<const double> initial_x,
                                     std::span<const double> initial_y, Observer& observer) {
    check(bodies);
    check_arrays(bodies.grid.size(), bound, rigid_x, rigid_y, initial_x, initial_y);
    const FrictionBodies friction{bodies.influence, &bodies.increment, bodies.grid, bodies.step_x, bodies.step_y};
    const Field rigid = field_of(rigid_x, rigid_y, bound.size()),
                estimate = field_of(initial_x, initial_y, bound.size());
    const FrictionTask task{bound, rigid, {}, Pair::Zero(), estimate, settings};
    return march_to_steady_state(friction, task, FrictionSolver(friction).solve(task, observer), observer);
}

}  // namespace contactd

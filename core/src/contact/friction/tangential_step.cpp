#include "tangential_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/tangential/slip.hpp"
#include "curved_strips.hpp"
#include "steady_rolling.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

FrictionBodies friction_bodies(const ContactProblem& problem, const ContactInfluence& influence) {
    const auto [x, y] = step_of(problem);
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    return {*influence.current, rolling && rolling->steady() ? influence.increment.get() : nullptr, problem.grid, x, y};
}

}  // namespace

bool prescribes_force(const Motion& motion) {
    return std::visit([](const auto& m) { return !m.force.empty(); }, motion);
}

TangentialStep::TangentialStep(const ContactProblem& problem, const ContactInfluence& influence)
    : problem_(problem),
      influence_(influence),
      n_(problem.grid.size()),
      motion_(problem.motion),
      solver_(friction_bodies(problem, influence)) {
    if (rolling()) unit_ = step_length(*rolling(), problem.grid);
}

// Returns the slip of the motion itself, w for a shift and dq w for rolling, plus the additional slip of the elements.
Field TangentialStep::rigid_slip() const {
    const auto of_plane = [&](const Grid& grid) {
        return rolling() ? contactd::rigid_slip(grid, *rolling(), unit_)
                         : contactd::rigid_slip(grid, std::get<Shift>(motion_));
    };
    RigidSlip slip =
        problem_.columns ? contactd::rigid_slip(*problem_.columns, problem_.grid, of_plane) : of_plane(problem_.grid);
    Field result;
    result.x = std::move(slip.x);
    result.y = std::move(slip.y);
    const RigidSlip& beside = problem_.rigid_slip;
    for (std::size_t i = 0; i < beside.x.size(); ++i) {
        result.x[i] += unit_ * beside.x[i];
        result.y[i] += unit_ * beside.y[i];
    }
    for (std::size_t i = 0; i < entering_.part.size(); ++i) {
        result.x[i] *= entering_.part[i];
        result.y[i] *= entering_.part[i];
    }
    return result;
}

// A particle that enters during the step slips from its point of entry on, and had the displacements of that point.
Field TangentialStep::history(std::span<const double> pressure) {
    entering_ = {};
    Field result = history_;
    if (!rolling() || is_steady()) return result;
    entering_ = entering_particles(problem_.grid, pressure, step_of(problem_));
    for (std::size_t i = 0; i < entering_.part.size(); ++i) {
        if (entering_.part[i] == 1) continue;
        result.x[i] = same_place_.x[entering_.from[i]];
        result.y[i] = same_place_.y[entering_.from[i]];
    }
    return result;
}

RollingBodies TangentialStep::bodies() const {
    const auto [x, y] = step_of(problem_);
    return {*influence_.current, *influence_.increment, problem_.grid, x, y};
}

// Particles had the displacements A' p_before of their previous positions, with A' = A - C; for a shift C is zero. A
// steady state has no previous step.
void TangentialStep::begin(const Tractions& before) {
    solver_.forget();
    is_first_ = true;
    history_ = Field(n_);
    if (is_steady()) return;
    Field u(n_);
    const auto add_product = [&](const auto& influence, double factor) {
        if (any(before.tangential)) {
            influence.tangential(before.tangential.x, before.tangential.y, u.x, u.y);
            add(history_, u, factor);
        }
        if (!influence.coupled()) return;
        influence.tangential_of_normal(before.pressure, u.x, u.y);
        add(history_, u, factor);
    };
    add_product(*influence_.current, -1);
    same_place_ = history_;
    if (rolling()) add_product(*influence_.increment, 1);
}

void TangentialStep::add_coupling(std::span<const double> pressure, Field& rigid) const {
    const auto add_product = [&](const auto& influence) {
        if (!influence.coupled()) return;
        Field u(n_);
        influence.tangential_of_normal(pressure, u.x, u.y);
        add(rigid, u);
    };
    if (is_steady())
        add_product(*influence_.increment);
    else
        add_product(*influence_.current);
}

RollingSolution TangentialStep::solve(std::span<const double> pressure, std::span<const double> bound,
                                      const Field& estimate, const SolverSettings& settings, const FlowTask* flow,
                                      Observer& observer) {
    flow_ = flow;
    Field rest = history(pressure);
    add_coupling(pressure, rest);
    solver_used_ = TangentialSolver::newton;
    RollingSolution solution = prescribes_force(motion_) ? solve_for_force(rest, bound, estimate, settings, observer)
                                                         : solve_for_motion(rest, bound, estimate, settings, observer);
    is_first_ = false;
    estimate_is_good_ = false;
    add_free_slip(pressure, bound, rest, solution);
    return solution;
}

RollingSolution TangentialStep::solve_for_motion(const Field& rest, std::span<const double> bound,
                                                 const Field& estimate, const SolverSettings& settings,
                                                 Observer& observer) {
    Field rigid = rigid_slip();
    add(rigid, rest);
    FrictionTask task{bound, rigid, {}, Pair::Zero(), estimate, settings, estimate_is_good_, flow_};
    if (asks_tang_cg()) return solve_with(task, observer);
    const FrictionSolution found = solver_.solve(task, observer);
    const int left = settings.max_iterations - found.evidence.iterations;
    if (found.evidence.converged || left <= 0 || flow_ != nullptr) return found;
    if (is_steady()) return march_to_steady_state(friction_bodies(problem_, influence_), task, found, observer);
    task.settings.max_iterations = left;
    RollingSolution other = solve_with(task, observer);
    other.evidence.iterations += found.evidence.iterations;
    return other;
}

// The solvers only consider elements with friction. Where there is contact without friction, the surfaces slip, too.
void TangentialStep::add_free_slip(std::span<const double> pressure, std::span<const double> bound, const Field& rest,
                                   RollingSolution& solution) const {
    const auto is_free = [&](std::size_t i) { return pressure[i] > 0 && !(bound[i] > 0); };
    std::size_t first = 0;
    while (first < n_ && !is_free(first)) ++first;
    if (first == n_) return;
    Field slip = rigid_slip(), u(n_);
    add(slip, rest);
    if (is_steady())
        influence_.increment->tangential(solution.traction_x, solution.traction_y, u.x, u.y);
    else
        influence_.current->tangential(solution.traction_x, solution.traction_y, u.x, u.y);
    for (std::size_t i = first; i < n_; ++i) {
        if (!is_free(i)) continue;
        solution.slip_x[i] = slip.x[i] + u.x[i];
        solution.slip_y[i] = slip.y[i] + u.y[i];
        solution.element_division[i] = ElementState::slip;
    }
}

// Solves by TangCG, from the start of Newton's method. Steady rolling, whose operator is not symmetric, and layers that
// harden are solved by Newton's method.
RollingSolution TangentialStep::solve_with(const FrictionTask& task, Observer& observer) {
    const std::span<const double> bound = task.bound;
    const Field& rigid = task.rigid;
    if (flow_ != nullptr) return FrictionSolver(friction_bodies(problem_, influence_)).solve(task, observer);
    if (is_steady()) {
        std::span<const double> x, y;
        if (any(task.estimate)) {
            x = task.estimate.x;
            y = task.estimate.y;
        }
        return solve_steady_rolling(bodies(), bound, rigid.x, rigid.y, task.settings, x, y, observer);
    }
    solver_used_ = TangentialSolver::tangcg;
    const Field first = task.estimate_is_good ? task.estimate : solver_.first_tractions(task, observer);
    RollingSolution solution;
    static_cast<TangentialSolution&>(solution) =
        solve_tangential(*influence_.current, bound, rigid.x, rigid.y, task.settings, first.x, first.y, observer);
    SlipDistance slip =
        slip_distance(*influence_.current, bound, rigid.x, rigid.y, solution.traction_x, solution.traction_y);
    solution.slip_x = std::move(slip.x);
    solution.slip_y = std::move(slip.y);
    return solution;
}

}  // namespace contactd

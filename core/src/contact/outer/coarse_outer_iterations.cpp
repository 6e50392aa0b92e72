#include "coarse_outer_iterations.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include "boundary_elements.hpp"
#include "closed_forms/undeformed_distance.hpp"
#include "contact/support/solver_support.hpp"

namespace contactd {
namespace {

constexpr std::ptrdiff_t smallest_to_coarsen = 1000;  // elements in contact
// Tolerances may be loose for an estimate, which has the coarser grid's error anyway.
constexpr double coarse_normal = 1e-3, coarse_tangential = 1e-2, coarse_outer = 1e-2;

std::optional<ContactInfluence> coarser(const ContactInfluence& fine) {
    const CoarserGrid* current = fine.current->coarser();
    const StepOperator* increment = fine.increment ? fine.increment->coarser() : nullptr;
    if (current == nullptr || (fine.increment && increment == nullptr)) return {};
    return ContactInfluence{{fine.current, &current->influence()},
                            fine.increment ? std::shared_ptr<const StepOperator>(fine.increment, increment) : nullptr};
}

// On the coarser grid forces are met only roughly, so forces near the bound of friction would be refused.
bool is_well_within_bound(const ContactProblem& problem) {
    constexpr double well = 0.95;
    const Force force = std::visit([](const auto& motion) { return motion.force; }, problem.motion);
    if (force.empty()) return true;
    return problem.Fn &&
           std::hypot(force.Fx.value_or(0), force.Fy.value_or(0)) <= well * problem.friction->mu.front() * *problem.Fn;
}

bool is_plain(const ContactProblem& problem) {
    const SurfaceState &before = problem.previous, &initial = problem.initial;
    return !problem.columns && problem.friction->mu.size() == 1 && !problem.friction->kinetic &&
           !problem.friction->follows_temperature() && problem.rigid_slip.empty() && before.pressure.empty() &&
           before.traction_x.empty() && before.traction_y.empty() && before.yield_stress.empty() &&
           initial.traction_x.empty() && initial.traction_y.empty() && is_well_within_bound(problem);
}

ContactProblem on_coarser(const ContactProblem& fine, const CoarserGrid& coarse, const std::vector<double>& distance) {
    ContactProblem problem = fine;
    problem.initial = problem.previous = {};
    problem.derivatives = false;
    problem.grid = coarser(fine.grid, coarse);
    if (!paraboloid_of(fine)) {
        std::vector<double> gap(problem.grid.size());
        coarse.average(distance, gap);
        problem.gap = std::move(gap);
    }
    if (auto* rolling = std::get_if<Rolling>(&problem.motion)) {
        rolling->dq = step_length(*rolling, fine.grid);
        rolling->steps = 1;
    }
    const auto loosen = [](SolverSettings& settings, double tolerance) {
        settings.tolerance = std::max(settings.tolerance, tolerance);
    };
    loosen(problem.settings.normal, coarse_normal);
    loosen(problem.settings.tangential, coarse_tangential);
    loosen(problem.settings.outer, coarse_outer);
    return problem;
}

}  // namespace

std::optional<OuterStart> outer_iterations_on_coarser(const ContactProblem& problem, const ContactInfluence& influence,
                                                      const std::vector<double>& distance,
                                                      const std::vector<double>& bound, const Observer& observer) {
    const auto in_contact = std::count_if(bound.begin(), bound.end(), [](double g) { return g > 0; });
    if (in_contact < smallest_to_coarsen || !is_plain(problem)) return {};
    const std::optional<ContactInfluence> coarse = coarser(influence);
    if (!coarse) return {};
    const CoarserGrid& grid = *influence.current->coarser();
    const ContactProblem there = on_coarser(problem, grid, distance);
    if (coarse->current->size() != there.grid.size()) return {};
    SilentObserver silent(observer);
    const ContactSolution solution = solve_boundary_elements(there, *coarse, silent);
    if (!solution.converged()) return {};
    OuterStart start{Field(problem.grid.size()), *solution.motion};
    auto& [x, y] = start.tractions;
    grid.interpolate(solution.traction_x, x);
    grid.interpolate(solution.traction_y, y);
    for (std::size_t i = 0; i < bound.size(); ++i) {
        const double size = std::sqrt(x[i] * x[i] + y[i] * y[i]);
        if (!(size > bound[i])) continue;
        x[i] *= bound[i] / size;
        y[i] *= bound[i] / size;
    }
    return start;
}

}  // namespace contactd

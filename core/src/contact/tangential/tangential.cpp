#include "tangential.hpp"

#include <algorithm>
#include <cmath>

#include "contact/support/contact_elements.hpp"
#include "contact/support/solver_support.hpp"
#include "operators/restriction.hpp"
#include "tang_cg.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr double coarse_tolerance = 3e-3;
// The relative error of an estimate from which a coarser grid gives a better start: the error of that falls with the
// number of elements along the contact.
constexpr double poor_estimate = 0.3, poor_times_elements = 20;

struct Problem {
    Values bound, rigid_x, rigid_y;
};

bool any(std::span<const double> values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
}

Field full_size(std::span<const double> x, std::span<const double> y, std::size_t n) {
    Field field(n);
    std::copy(x.begin(), x.end(), field.x.begin());
    std::copy(y.begin(), y.end(), field.y.begin());
    return field;
}

TangentialSolution solve(const InfluenceOperator& influence, const Problem& problem, const SolverSettings& settings,
                         const Field* initial, bool as_estimate, Observer& observer);

// The traction over its bound is smooth up to the edge of the contact: that is interpolated, weighted with the bound,
// so that slip on the coarser grid is slip on the finer one.
Field refined(const CoarserGrid& grid, const Values& fine_bound, const Values& coarse_bound,
              const TangentialSolution& coarse) {
    Field tractions(fine_bound.size());
    Values weight(fine_bound.size());
    grid.interpolate(coarse.traction_x, tractions.x);
    grid.interpolate(coarse.traction_y, tractions.y);
    grid.interpolate(coarse_bound, weight);
    for (std::size_t i = 0; i < weight.size(); ++i) {
        const double factor = weight[i] > 0 ? fine_bound[i] / weight[i] : 0;
        tractions.x[i] *= factor;
        tractions.y[i] *= factor;
    }
    return tractions;
}

Field estimate_on_coarser_grid(const InfluenceOperator& influence, const Problem& problem,
                               const SolverSettings& settings, const Observer& observer) {
    const CoarserGrid& grid = *influence.coarser();
    const auto to_coarser = [&](const Values& fine) {
        Values coarse(grid.influence().size());
        grid.average(fine, coarse);
        return coarse;
    };
    SolverSettings coarse_settings = settings;
    coarse_settings.tolerance = std::max(settings.tolerance, coarse_tolerance);
    SilentObserver silent(observer);
    const Problem coarse{to_coarser(problem.bound), to_coarser(problem.rigid_x), to_coarser(problem.rigid_y)};
    return refined(grid, problem.bound, coarse.bound,
                   solve(grid.influence(), coarse, coarse_settings, nullptr, true, silent));
}

TangentialSolution solve(const InfluenceOperator& influence, const Problem& problem, const SolverSettings& settings,
                         const Field* initial, bool as_estimate, Observer& observer) {
    const Contact contact(problem.bound, problem.rigid_x, problem.rigid_y);
    TangCg solver(influence, contact, settings, observer);
    const bool can_coarsen = influence.coarser() != nullptr && contact.size() > 0;
    const double poor =
        std::min(poor_estimate, poor_times_elements / std::sqrt(static_cast<double>(contact.size() + 1)));
    if (initial != nullptr && (solver.start(*initial) <= poor || !can_coarsen)) return solver.solve(as_estimate);
    if (can_coarsen)
        solver.start(estimate_on_coarser_grid(influence, problem, settings, observer));
    else
        solver.start(Field(influence.size()));
    return solver.solve(as_estimate);
}

}  // namespace

TangentialSolution solve_tangential(const InfluenceOperator& influence, std::span<const double> bound,
                                    std::span<const double> rigid_x, std::span<const double> rigid_y,
                                    const SolverSettings& settings, std::span<const double> initial_x,
                                    std::span<const double> initial_y, Observer& observer) {
    require_size(bound, influence.size(), "bound");
    require_size(rigid_x, influence.size(), "rigid_x");
    require_size(rigid_y, influence.size(), "rigid_y");
    if (!initial_x.empty()) require_size(initial_x, influence.size(), "initial.traction_x");
    if (!initial_y.empty()) require_size(initial_y, influence.size(), "initial.traction_y");
    const Stopwatch stopwatch;
    const Restriction restriction(
        influence, bounding_box(extent_of(influence), [&](std::size_t i) { return bound[i] > 0; }), false);
    const Problem problem{restriction.crop(bound), restriction.crop(rigid_x), restriction.crop(rigid_y)};
    const bool has_estimate = any(initial_x) || any(initial_y);
    const Field whole = full_size(initial_x, initial_y, influence.size());
    Field initial;
    initial.x = restriction.crop(whole.x);
    initial.y = restriction.crop(whole.y);
    const TangentialSolution part =
        solve(restriction.influence(), problem, settings, has_estimate ? &initial : nullptr, false, observer);
    TangentialSolution solution;
    solution.traction_x.resize(influence.size());
    solution.traction_y.resize(influence.size());
    solution.element_division.assign(influence.size(), ElementState::exterior);
    restriction.paste(part.traction_x, solution.traction_x);
    restriction.paste(part.traction_y, solution.traction_y);
    restriction.paste(part.element_division, solution.element_division);
    solution.evidence = part.evidence;
    solution.evidence.seconds = stopwatch.seconds();
    return solution;
}

}  // namespace contactd

#include "contactd/tangential.hpp"

#include <algorithm>

#include "contact_elements.hpp"
#include "solver_support.hpp"
#include "tang_cg.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr double coarse_tolerance = 1e-3;
constexpr double good_estimate = 0.01;  // relative error from which a coarser grid gives a better start

Field estimate_on_coarser_grid(const InfluenceOperator& influence, std::span<const double> bound,
                               std::span<const double> rigid_x, std::span<const double> rigid_y,
                               const SolverSettings& settings, const Observer& observer) {
    const InfluenceOperator& coarser = *influence.coarser();
    const auto to_coarser = [&](std::span<const double> fine) {
        Values coarse(coarser.size());
        influence.to_coarser(fine, coarse);
        return coarse;
    };
    SolverSettings coarse_settings = settings;
    coarse_settings.tolerance = std::max(settings.tolerance, coarse_tolerance);
    SilentObserver silent(observer);
    const TangentialSolution coarse = solve_tangential(coarser, to_coarser(bound), to_coarser(rigid_x),
                                                       to_coarser(rigid_y), coarse_settings, {}, {}, silent);
    Field estimate(influence.size());
    influence.from_coarser(coarse.traction_x, estimate.x);
    influence.from_coarser(coarse.traction_y, estimate.y);
    return estimate;
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
    const Contact contact(bound, rigid_x, rigid_y);
    TangCg solver(influence, contact, settings, observer);
    Field estimate(influence.size());
    std::copy(initial_x.begin(), initial_x.end(), estimate.x.begin());
    std::copy(initial_y.begin(), initial_y.end(), estimate.y.begin());
    const bool from_nothing = initial_x.empty() && initial_y.empty();
    const bool can_coarsen = influence.coarser() != nullptr;
    if ((can_coarsen && from_nothing) || (solver.start(estimate) > good_estimate && can_coarsen))
        solver.start(estimate_on_coarser_grid(influence, bound, rigid_x, rigid_y, settings, observer));
    TangentialSolution solution = solver.solve();
    solution.evidence.seconds = stopwatch.seconds();
    return solution;
}

}  // namespace contactd

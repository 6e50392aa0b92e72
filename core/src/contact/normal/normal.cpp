#include "normal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "contact/support/solver_support.hpp"
#include "norm.hpp"
#include "operators/restriction.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr double coarse_tolerance = 1e-4;
constexpr double poor_estimate = 0.3;             // relative error from which a coarser grid gives a better start
constexpr double poor_beside_closed_form = 4e-3;  // the same of a closed form
constexpr double rounding = 1e-14;

struct Task {
    const InfluenceOperator& influence;
    NormProblem problem;
    const SolverSettings& settings;
};

bool any_pressure(std::span<const double> p) {
    return std::any_of(p.begin(), p.end(), [](double value) { return value > 0; });
}

struct Start {
    Values pressure;                              // may be empty
    bool set_is_good = false;                     // as of Norm::start
    std::function<bool(double error)> is_poor{};  // something else is the better start; null: nothing is
};

std::optional<NormalSolution> solve_from(const Task& task, Start start, Observer& observer);
NormalSolution solve_from_coarser(const Task& task, Observer& observer);

// Coarse pressures on the finer grid: the square of the pressure is smooth up to the edge of the contact, so that is
// interpolated, no element beyond the coarse contact gets any, and every coarse element keeps its force, without which
// the displacements far from it would be wrong.
Values refined(const CoarserGrid& grid, std::size_t fine_size, const Values& coarse) {
    Values squares = coarse, factors(coarse.size()), result(fine_size), copied(fine_size);
    for (double& value : squares) value = std::max(value, 0.0) * std::max(value, 0.0);
    grid.interpolate(squares, result);
    for (double& value : result) value = std::sqrt(value);
    grid.average(result, factors);
    for (std::size_t i = 0; i < coarse.size(); ++i) factors[i] = coarse[i] > 0 ? coarse[i] / factors[i] : 0;
    grid.copy(factors, copied);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] *= copied[i];
    return result;
}

Values estimate_on_coarser_grid(const Task& task, const Observer& observer) {
    const CoarserGrid& grid = *task.influence.coarser();
    Values distance(grid.influence().size());
    grid.average(task.problem.distance, distance);
    SolverSettings settings = task.settings;
    settings.tolerance = std::max(settings.tolerance, coarse_tolerance);
    NormProblem problem{distance, task.problem.pressure_sum, true};
    if (problem.pressure_sum) *problem.pressure_sum /= grid.ratio();
    SilentObserver silent(observer);
    return refined(grid, task.influence.size(),
                   solve_from_coarser({grid.influence(), problem, settings}, silent).pressure);
}

NormalSolution solve_from_coarser(const Task& task, Observer& observer) {
    if (task.influence.coarser() == nullptr) return *solve_from(task, {}, observer);
    return *solve_from(task, {estimate_on_coarser_grid(task, observer), true, {}}, observer);
}

// Elements outside the box that overlap under the pressures within it.
ElementBox overlaps_outside(const Task& task, const Restriction& restriction, const NormalSolution& solution) {
    Values u(task.influence.size());
    task.influence.normal(solution.pressure, u);
    const auto& h = task.problem.distance;
    return bounding_box(extent_of(task.influence), [&](std::size_t i) {
        const double gap = u[i] + h[i] - solution.approach;
        return gap < -rounding * (std::abs(u[i]) + std::abs(h[i]) + std::abs(solution.approach)) &&
               !restriction.contains(i);
    });
}

// Solves on a box around the estimate, or where the undeformed bodies overlap without one, and makes it larger as long
// as the contact conditions are violated outside. Nothing where the start is too far off.
std::optional<NormalSolution> solve_from(const Task& task, Start start, Observer& observer) {
    const ElementBox extent = extent_of(task.influence);
    NormalSolution solution;
    solution.pressure = std::move(start.pressure);
    const bool from_nothing = !any_pressure(solution.pressure);
    if (from_nothing) solution.pressure.assign(task.influence.size(), 0.0);
    ElementBox needed = from_nothing && task.problem.pressure_sum
                            ? extent
                            : bounding_box(extent, [&](std::size_t i) { return solution.pressure[i] > 0; });
    if (needed.nx == 0) needed = bounding_box(extent, [&](std::size_t i) { return task.problem.distance[i] < 0; });
    SolverSettings settings = task.settings;
    for (int iterations = 0;;) {
        const Restriction restriction(task.influence, needed, true);
        const Values distance = restriction.crop(task.problem.distance);
        NormProblem problem = task.problem;
        problem.distance = distance;
        Norm norm(restriction.influence(), problem, settings, observer);
        const double error = norm.start(restriction.crop(solution.pressure), start.set_is_good);
        if (start.is_poor && start.is_poor(error)) return {};
        solution.evidence = norm.solve();
        iterations += solution.evidence.iterations;
        solution.evidence.iterations = iterations;
        solution.approach = norm.approach();
        std::fill(solution.pressure.begin(), solution.pressure.end(), 0.0);
        restriction.paste(norm.pressure(), solution.pressure);
        if (restriction.is_whole() || problem.estimate_only || !solution.evidence.converged) return solution;
        const ElementBox outside = overlaps_outside(task, restriction, solution);
        if (outside.nx == 0) return solution;
        needed = united(restriction.box(), outside);
        settings.max_iterations = std::max(task.settings.max_iterations - iterations, 0);
        start.set_is_good = false;
        start.is_poor = nullptr;
    }
}

NormalSolution solve_from_best(const Task& task, std::span<const double> initial, const PressureEstimate& closed_form,
                               Observer& observer) {
    const auto is_poor = [&](double error) { return error > poor_estimate && task.influence.coarser() != nullptr; };
    Values known;
    const auto is_known = [&] {
        if (closed_form) known = closed_form();
        return any_pressure(known);
    };
    if (any_pressure(initial)) {
        const auto is_poor_beside = [&](double error) {
            return (error > poor_beside_closed_form && is_known()) || is_poor(error);
        };
        if (auto solution = solve_from(task, {{initial.begin(), initial.end()}, false, is_poor_beside}, observer))
            return *std::move(solution);
    }
    if (any_pressure(known) || (!any_pressure(initial) && is_known()))
        if (auto solution = solve_from(task, {std::move(known), false, is_poor}, observer)) return *std::move(solution);
    return solve_from_coarser(task, observer);
}

NormalSolution solve(const Task& task, std::span<const double> initial, const PressureEstimate& closed_form,
                     Observer& observer) {
    if (!initial.empty()) require_size(initial, task.influence.size(), "initial.pressure");
    const Stopwatch stopwatch;
    NormalSolution solution = solve_from_best(task, initial, closed_form, observer);
    solution.evidence.seconds = stopwatch.seconds();
    return solution;
}

}  // namespace

NormalSolution solve_normal(const InfluenceOperator& influence, std::span<const double> gap,
                            const SolverSettings& settings, std::span<const double> initial, Observer& observer,
                            const PressureEstimate& closed_form) {
    require_size(gap, influence.size(), "gap");
    return solve({influence, {gap, {}}, settings}, initial, closed_form, observer);
}

NormalSolution solve_normal_force(const InfluenceOperator& influence, std::span<const double> undeformed_distance,
                                  double pressure_sum, const SolverSettings& settings, std::span<const double> initial,
                                  Observer& observer, const PressureEstimate& closed_form) {
    require_size(undeformed_distance, influence.size(), "undeformed_distance");
    if (!(pressure_sum >= 0) || !std::isfinite(pressure_sum))
        throw InvalidArgument("Fn", "must be finite and not negative: bodies in contact do not pull at each other");
    // Only differences of the distance matter.
    const double least = *std::min_element(undeformed_distance.begin(), undeformed_distance.end());
    Values distance(undeformed_distance.begin(), undeformed_distance.end());
    for (double& h : distance) h -= least;
    NormalSolution solution;
    if (pressure_sum > 0) {
        solution = solve({influence, {distance, pressure_sum}, settings}, initial, closed_form, observer);
    } else {
        solution.pressure.resize(distance.size());
        solution.evidence.converged = true;
    }
    solution.approach += least;
    return solution;
}

int border_elements(const Grid& grid, std::span<const double> pressure, bool line_contact) {
    require_size(pressure, grid.size(), "pressure");
    int count = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const bool inside = ix > 0 && ix < grid.nx - 1 && (line_contact || (iy > 0 && iy < grid.ny - 1));
            count += !inside && pressure[static_cast<std::size_t>(iy * grid.nx + ix)] > 0;
        }
    return count;
}

}  // namespace contactd

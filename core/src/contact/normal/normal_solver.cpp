#include "normal_solver.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "asymmetric_norm.hpp"
#include "contact/support/solver_support.hpp"
#include "operators/restriction.hpp"

namespace contactd {

using Values = std::vector<double>;

namespace {

struct NormTask {
    NormProblem problem;
    SolverSettings settings;
};

}  // namespace

// Holds elements around a contact, and the iteration on them.
class NormalBox {
   public:
    NormalBox(const InfluenceOperator& influence, const NormTask& task, const ElementBox& needed, Observer& observer)
        : influence_(influence),
          restriction_(influence, needed, true),
          distance_(restriction_.crop(task.problem.distance)),
          norm_(make_norm(restriction_.influence(), here(task.problem), task.settings, observer)) {}

    // Starts like Norm::start.
    double start(std::span<const double> estimate, bool set_is_good) {
        return norm_->start(restriction_.crop(estimate), set_is_good);
    }

    void go_on(const NormTask& task, Observer& observer) {
        distance_ = restriction_.crop(task.problem.distance);
        norm_->go_on(here(task.problem), task.settings, observer);
    }

    NormalSolution solve() {
        NormalSolution solution;
        solution.evidence = norm_->solve();
        solution.approach = norm_->approach();
        solution.pressure.resize(influence_.size());
        restriction_.paste(norm_->pressure(), solution.pressure);
        return solution;
    }

    const ElementBox& box() const { return restriction_.box(); }

    // Returns the elements outside the box that overlap under the pressures within it.
    ElementBox overlaps_outside(std::span<const double> h, const NormalSolution& solution) const {
        constexpr double rounding = 1e-14;
        if (restriction_.is_whole()) return {};
        Values u(influence_.size());
        influence_.normal(solution.pressure, u);
        return bounding_box(extent_of(influence_), [&](std::size_t i) {
            const double gap = u[i] + h[i] - solution.approach;
            return gap < -rounding * (std::abs(u[i]) + std::abs(h[i]) + std::abs(solution.approach)) &&
                   !restriction_.contains(i);
        });
    }

   private:
    NormProblem here(NormProblem problem) const {
        problem.distance = distance_;
        return problem;
    }

    const InfluenceOperator& influence_;
    const Restriction restriction_;
    Values distance_;
    std::unique_ptr<Norm> norm_;
};

namespace {

constexpr double coarse_tolerance = 1e-4;
constexpr double poor_estimate = 0.3;             // relative error above which a coarser grid is a better start
constexpr double poor_beside_closed_form = 4e-3;  // the same for a closed form

bool any_pressure(std::span<const double> p) {
    return std::any_of(p.begin(), p.end(), [](double value) { return value > 0; });
}

struct Start {
    Values pressure;                              // may be empty
    bool set_is_good = false;                     // as in Norm::start
    std::function<bool(double error)> is_poor{};  // whether there is a better start; null: there is none
};

struct Found {
    NormalSolution solution;
    std::unique_ptr<NormalBox> box;  // on which it was computed
};

std::optional<Found> solve_from(const InfluenceOperator& influence, const NormTask& task, Start start,
                                Observer& observer);
Found solve_from_coarser(const InfluenceOperator& influence, const NormTask& task, Observer& observer);

// Returns coarse pressures on the finer grid. The square of the pressure is smooth up to the edge of the contact, so it
// is interpolated. Elements beyond the coarse contact get no pressure. Every coarse element keeps its force, because
// otherwise distant displacements would be wrong.
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

Values estimate_on_coarser_grid(const InfluenceOperator& influence, const NormTask& task, const Observer& observer) {
    const CoarserGrid& grid = *influence.coarser();
    Values distance(grid.influence().size());
    grid.average(task.problem.distance, distance);
    NormTask coarse{{distance, task.problem.pressure_sum, true}, task.settings};
    coarse.settings.tolerance = std::max(coarse.settings.tolerance, coarse_tolerance);
    if (coarse.problem.pressure_sum) *coarse.problem.pressure_sum /= grid.ratio();
    SilentObserver silent(observer);
    return refined(grid, influence.size(), solve_from_coarser(grid.influence(), coarse, silent).solution.pressure);
}

Found solve_from_coarser(const InfluenceOperator& influence, const NormTask& task, Observer& observer) {
    if (influence.coarser() == nullptr) return *solve_from(influence, task, {}, observer);
    return *solve_from(influence, task, {estimate_on_coarser_grid(influence, task, observer), true, {}}, observer);
}

// Solves on a box around the estimate or, without one, around the overlap of the undeformed bodies. The box grows as
// long as the contact conditions are violated outside. Returns nothing if the start is too inaccurate.
std::optional<Found> solve_from(const InfluenceOperator& influence, const NormTask& task, Start start,
                                Observer& observer) {
    const ElementBox extent = extent_of(influence);
    const bool from_nothing = !any_pressure(start.pressure);
    if (from_nothing) start.pressure.assign(influence.size(), 0.0);
    ElementBox needed = from_nothing && task.problem.pressure_sum
                            ? extent
                            : bounding_box(extent, [&](std::size_t i) { return start.pressure[i] > 0; });
    if (needed.nx == 0) needed = bounding_box(extent, [&](std::size_t i) { return task.problem.distance[i] < 0; });
    NormTask here = task;
    for (int iterations = 0;;) {
        auto box = std::make_unique<NormalBox>(influence, here, needed, observer);
        const double error = box->start(start.pressure, start.set_is_good);
        if (start.is_poor && start.is_poor(error)) return {};
        NormalSolution solution = box->solve();
        iterations += solution.evidence.iterations;
        solution.evidence.iterations = iterations;
        const bool is_checked = !task.problem.estimate_only && solution.evidence.converged;
        const ElementBox outside = is_checked ? box->overlaps_outside(task.problem.distance, solution) : ElementBox{};
        if (outside.nx == 0) return Found{std::move(solution), std::move(box)};
        needed = united(box->box(), outside);
        here.settings.max_iterations = std::max(task.settings.max_iterations - iterations, 0);
        start = {std::move(solution.pressure), false, {}};
    }
}

Found solve_from_best(const InfluenceOperator& influence, const NormTask& task, std::span<const double> initial,
                      const PressureEstimate& closed_form, Observer& observer) {
    // A closed form neglects creep; coarser grids do not.
    const double poor = influence.is_symmetric() ? poor_estimate : poor_beside_closed_form;
    const auto is_poor = [&](double error) { return error > poor && influence.coarser() != nullptr; };
    Values known;
    const auto is_known = [&] {
        if (closed_form && influence.is_symmetric()) known = closed_form();
        return any_pressure(known);
    };
    if (any_pressure(initial)) {
        const auto is_poor_beside = [&](double error) {
            return (error > poor_beside_closed_form && is_known()) || is_poor(error);
        };
        if (auto found =
                solve_from(influence, task, {{initial.begin(), initial.end()}, false, is_poor_beside}, observer))
            return *std::move(found);
    }
    if (any_pressure(known) || (!any_pressure(initial) && is_known()))
        if (auto found = solve_from(influence, task, {std::move(known), false, is_poor}, observer))
            return *std::move(found);
    return solve_from_coarser(influence, task, observer);
}

// If the approach is computed, only differences of the distance matter, so the least one becomes zero.
struct Shifted {
    explicit Shifted(const NormalTask& task) : gap(task.gap.begin(), task.gap.end()) {
        if (!task.pressure_sum) return;
        least = *std::min_element(gap.begin(), gap.end());
        for (double& h : gap) h -= least;
    }
    NormTask task(const NormalTask& whole) const { return {{gap, whole.pressure_sum}, whole.settings}; }

    Values gap;
    double least = 0;
};

void check(const NormalTask& task, std::size_t size) {
    require_size(task.gap, size, task.pressure_sum ? "undeformed_distance" : "gap");
    if (task.pressure_sum && (!(*task.pressure_sum >= 0) || !std::isfinite(*task.pressure_sum)))
        throw InvalidArgument("Fn",
                              "must be finite and not negative: contact without adhesion carries compression only");
}

}  // namespace

NormalSolver::NormalSolver(const InfluenceOperator& influence) : influence_(influence) {}
NormalSolver::~NormalSolver() = default;

NormalSolution NormalSolver::solve(const NormalTask& task, std::span<const double> initial,
                                   const PressureEstimate& closed_form, Observer& observer) {
    check(task, influence_.size());
    if (!initial.empty()) require_size(initial, influence_.size(), "initial.pressure");
    const Stopwatch stopwatch;
    box_.reset();  // frees its memory for the next one
    const Shifted shifted(task);
    NormalSolution solution;
    if (task.pressure_sum == 0.0) {
        solution.pressure.resize(influence_.size());
        solution.evidence.converged = true;
    } else {
        Found found = solve_from_best(influence_, shifted.task(task), initial, closed_form, observer);
        if (found.solution.evidence.converged) box_ = std::move(found.box);
        solution = std::move(found.solution);
    }
    solution.approach += shifted.least;
    solution.evidence.seconds = stopwatch.seconds();
    return solution;
}

NormalSolution NormalSolver::solve_again(const NormalTask& task, std::span<const double> initial, Observer& observer) {
    if (!box_) return solve(task, initial, {}, observer);
    check(task, influence_.size());
    const Stopwatch stopwatch;
    const Shifted shifted(task);
    box_->go_on(shifted.task(task), observer);
    NormalSolution solution = box_->solve();
    const bool converged = solution.evidence.converged;
    if (converged && (task.to_be_refined || box_->overlaps_outside(shifted.gap, solution).nx == 0)) {
        solution.approach += shifted.least;
    } else {
        const int iterations = solution.evidence.iterations;
        NormalTask rest = task;
        rest.settings.max_iterations = std::max(task.settings.max_iterations - iterations, 0);
        solution = solve(rest, converged ? std::span<const double>(solution.pressure) : initial, {}, observer);
        solution.evidence.iterations += iterations;
    }
    solution.evidence.seconds = stopwatch.seconds();
    return solution;
}

}  // namespace contactd

#include "rolling.hpp"

#include <algorithm>
#include <cmath>

#include "coarse_start.hpp"
#include "newton_solution.hpp"
#include "rolling_compliance.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr std::size_t smallest_to_coarsen = 1000;  // elements in contact
// From this many elements in contact on, a coarser grid gives a better start than an estimate whose residual is larger
// than this over the number of elements along the contact.
constexpr std::size_t smallest_to_doubt = 4000;
constexpr double poor_times_elements = 10;
constexpr int most_rounds = 2;            // of marching on and trying again
constexpr int most_steps = 120;           // of one march
constexpr double march_tolerance = 1e-4;  // a start for the direct iteration needs no more

void check(const RollingBodies& bodies) {
    validate(bodies.grid, "grid");
    const double dq = std::hypot(bodies.step_x, bodies.step_y);
    if (!(dq > 0) || !std::isfinite(dq))
        throw InvalidArgument("rolling.dq", "is " + number_text(dq) + "; it must be positive and finite");
    if (bodies.influence.size() != bodies.grid.size() || bodies.change.size() != bodies.grid.size())
        throw InvalidArgument("grid", "has " + std::to_string(bodies.grid.size()) + " elements; the coefficients are " +
                                          "for " + std::to_string(bodies.influence.size()) + ", and " +
                                          std::to_string(bodies.change.size()) + " for the change over a step");
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

// w - A' p, with A' = A - C.
RigidSlip rigid_slip_after(const RollingBodies& bodies, std::span<const double> rigid_x,
                           std::span<const double> rigid_y, std::span<const double> px, std::span<const double> py) {
    const std::size_t n = bodies.grid.size();
    RigidSlip result{Values(n), Values(n)};
    Values x(n), y(n);
    bodies.change.tangential(px, py, result.x, result.y);
    bodies.influence.tangential(px, py, x, y);
    for (std::size_t i = 0; i < n; ++i) {
        result.x[i] += rigid_x[i] - x[i];
        result.y[i] += rigid_y[i] - y[i];
    }
    return result;
}

// The transient from the tractions `p` until they stand, nearly; a better start for the direct iteration.
void march(const RollingBodies& bodies, std::span<const double> bound, std::span<const double> rigid_x,
           std::span<const double> rigid_y, Field& p, Observer& observer) {
    SilentObserver silent(observer);
    const SolverSettings settings{march_tolerance, 200};
    for (int step = 0; step < most_steps; ++step) {
        const RigidSlip rigid = rigid_slip_after(bodies, rigid_x, rigid_y, p.x, p.y);
        TangentialSolution next =
            solve_tangential(bodies.influence, bound, rigid.x, rigid.y, settings, p.x, p.y, silent);
        double change = 0;
        for (std::size_t i = 0; i < bound.size(); ++i)
            change += std::pow(next.traction_x[i] - p.x[i], 2) + std::pow(next.traction_y[i] - p.y[i], 2);
        p.x = std::move(next.traction_x);
        p.y = std::move(next.traction_y);
        if (change <= march_tolerance * march_tolerance * inner(p, p)) return;
    }
}

// On all elements of the grid.
RollingSolution solve_steady(const RollingBodies& bodies, std::span<const double> bound,
                             std::span<const double> rigid_x, std::span<const double> rigid_y,
                             const SolverSettings& settings, std::span<const double> initial_x,
                             std::span<const double> initial_y, Observer& observer) {
    const std::size_t n = bodies.grid.size();
    const Contact contact(bound, rigid_x, rigid_y);
    RollingCompliance compliance(bodies, contact);
    FrictionNewton solver(compliance, contact);
    Field estimate(n);
    std::copy(initial_x.begin(), initial_x.end(), estimate.x.begin());
    std::copy(initial_y.begin(), initial_y.end(), estimate.y.begin());
    bool started = false;
    if (contact.size() >= smallest_to_doubt && !(initial_x.empty() && initial_y.empty())) {
        solver.start(estimate);
        solver.iterate(0, settings, observer);
        started = solver.evidence().residual * std::sqrt(static_cast<double>(contact.size())) <= poor_times_elements;
    }
    const bool has_estimate = contact.size() >= smallest_to_doubt ? started : !(initial_x.empty() && initial_y.empty());
    if (!has_estimate && contact.size() >= smallest_to_coarsen)
        estimate = start_on_coarser({bodies.influence, &bodies.change, bodies.grid, bodies.step_x, bodies.step_y},
                                    contact, {}, Pair::Zero(), observer)
                       .tractions;
    for (int round = 0;; ++round) {
        if (!started || round > 0) solver.start(estimate);
        const bool converged =
            solver.iterate(settings.max_iterations - solver.evidence().iterations, settings, observer);
        if (converged || solver.evidence().iterations >= settings.max_iterations || round == most_rounds) break;
        contact.scatter(solver.tractions().x, estimate.x);
        contact.scatter(solver.tractions().y, estimate.y);
        march(bodies, bound, rigid_x, rigid_y, estimate, observer);
    }
    return solution_of(solver, contact, n);
}

}  // namespace

RigidSlip rigid_slip(const Grid& grid, const Rolling& rolling, double dq) {
    const double ahead = rolling.spin_offset * dq;
    const double ahead_x = ahead * std::cos(rolling.chi), ahead_y = ahead * std::sin(rolling.chi);
    RigidSlip result;
    result.x.reserve(grid.size());
    result.y.reserve(grid.size());
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            result.x.push_back(dq * (rolling.xi - rolling.phi * (grid.y(iy) + ahead_y)));
            result.y.push_back(dq * (rolling.eta + rolling.phi * (grid.x(ix) + ahead_x)));
        }
    return result;
}

RigidSlip rigid_slip(const Grid& grid, const Shift& shift) {
    return rigid_slip(
        grid, Rolling{.xi = shift.rigid_shift.x, .eta = shift.rigid_shift.y, .phi = shift.rotation, .spin_offset = 0},
        1);
}

RollingSolution solve_steady_rolling(const RollingBodies& bodies, std::span<const double> bound,
                                     std::span<const double> rigid_x, std::span<const double> rigid_y,
                                     const SolverSettings& settings, std::span<const double> initial_x,
                                     std::span<const double> initial_y, Observer& observer) {
    check(bodies);
    check_arrays(bodies.grid.size(), bound, rigid_x, rigid_y, initial_x, initial_y);
    const Stopwatch stopwatch;
    const Restriction restriction(
        bodies.influence, bounding_box(extent_of(bodies.influence), [&](std::size_t i) { return bound[i] > 0; }),
        false);
    const std::shared_ptr<const StepOperator> change =
        restriction.is_whole() ? nullptr : bodies.change.on(restriction.box());
    RollingSolution result;
    if (!change) {
        result = solve_steady(bodies, bound, rigid_x, rigid_y, settings, initial_x, initial_y, observer);
    } else {
        const RollingBodies on_box{restriction.influence(), *change, restriction.crop(bodies.grid), bodies.step_x,
                                   bodies.step_y};
        const auto crop = [&](std::span<const double> whole) {
            return whole.empty() ? Values{} : restriction.crop(whole);
        };
        const RollingSolution part = solve_steady(on_box, crop(bound), crop(rigid_x), crop(rigid_y), settings,
                                                  crop(initial_x), crop(initial_y), observer);
        result = whole_of(part, restriction, bodies.grid.size());
    }
    result.evidence.seconds = stopwatch.seconds();
    return result;
}

TangentialForces tangential_forces(const Grid& grid, std::span<const double> traction_x,
                                   std::span<const double> traction_y) {
    require_size(traction_x, grid.size(), "traction_x");
    require_size(traction_y, grid.size(), "traction_y");
    TangentialForces sum;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const std::size_t i =
                static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
            sum.Fx += traction_x[i];
            sum.Fy += traction_y[i];
            sum.Mz += grid.x(ix) * traction_y[i] - grid.y(iy) * traction_x[i];
        }
    const double area = grid.element_area();
    return {sum.Fx * area, sum.Fy * area, sum.Mz * area};
}

}  // namespace contactd

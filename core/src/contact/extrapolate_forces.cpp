#include "contactd/extrapolate_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/undeformed_distance.hpp"
#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Scaled = std::array<double, 3>;  // Fx, Fy and Mz/c over mu Fn

// The stated error is the difference of two extrapolations plus this share of mu Fn, the noise of the elements at the
// leading edge. tests/integration/test_force_accuracy.py compares it with converged forces.
struct Level {
    int n;
    double force_noise, moment_noise;  // not used for the first two, which only begin the extrapolations
};
constexpr std::array levels{Level{9, 0, 0}, Level{18, 0, 0}, Level{36, 1.2e-3, 1.6e-3}, Level{72, 2.5e-4, 5e-4},
                            Level{144, 1.5e-4, 2.3e-4}};
// Where the solver needs more iterations, near pure spin at full slip, finer grids may take minutes.
constexpr int most_iterations = 50;
constexpr double least_ratio = 0.05, largest_ratio = 20;  // of a/b, for which errors have been verified

/// Holds a contact in the units of its scaled problems.
struct ScaledContact {
    SemiAxes axes;  // with ab = 1
    double nu = 0;
    double bound = 0, size = 0;  // mu Fn and sqrt(ab) of the contact
    Rolling rolling;
};

ScaledContact scaled(const ContactProblem& problem, const HertzContact& found) {
    const double ratio = found.a / found.b;
    if (!(ratio >= least_ratio && ratio <= largest_ratio))
        throw InvalidArgument("gap", "results in a contact ellipse with a/b = " + short_text(ratio) +
                                         ", but accuracy is verified for 0.05 to 20 only; change the gap, or remove "
                                         "accuracy");
    const Material combined = combined_material(problem.bodies.materials());
    const double root = std::sqrt(rounded(ratio)), area = found.a * found.b;  // Rounding keeps keys of operators equal.
    ScaledContact contact{{root, 1 / root}, combined.nu, problem.friction->mu[0] * found.Fn, std::sqrt(area), {}};
    const auto& rolling = std::get<Rolling>(problem.motion);
    const double unit = combined.G * area / contact.bound;
    contact.rolling.xi = unit * rolling.xi;
    contact.rolling.eta = unit * rolling.eta;
    contact.rolling.phi = unit * contact.size * rolling.phi;
    contact.rolling.chi = rolling.chi;
    contact.rolling.spin_offset = 0.25;
    return contact;
}

Grid grid_of(const ScaledContact& contact, int n) {
    const bool along_x = std::abs(std::cos(contact.rolling.chi)) > 0.5;
    const int nx = along_x ? n : 2 * n, ny = along_x ? 2 * n : n;
    return Grid::of_elements(nx, ny, 2 * contact.axes.a / nx, 2 * contact.axes.b / ny);
}

ContactProblem problem_on(const Grid& grid, const ScaledContact& contact) {
    ContactProblem problem;
    problem.grid = grid;
    problem.bodies = Bodies::of({{1, contact.nu}, {1, contact.nu}});
    problem.gap = contact.axes;
    problem.Fn = 1;
    problem.friction = FrictionLaw{{1}};
    problem.motion = contact.rolling;
    return problem;
}

Scaled extrapolated(const Scaled& coarse, const Scaled& fine) {
    return {2 * fine[0] - coarse[0], 2 * fine[1] - coarse[1], 2 * fine[2] - coarse[2]};
}

GridForces forces_on(const Grid& grid, const Scaled& forces, const ScaledContact& contact) {
    return {grid.nx, grid.ny, contact.bound * forces[0], contact.bound * forces[1],
            contact.bound * contact.size * forces[2]};
}

void warn(const ForceAccuracy& reached, double requested, ContactSolution& solution) {
    const double error = std::max(reached.force_error, reached.moment_error);
    const std::string grids = std::to_string(reached.coarse.nx) + " x " + std::to_string(reached.coarse.ny) + " and " +
                              std::to_string(reached.fine.nx) + " x " + std::to_string(reached.fine.ny) + " elements";
    solution.warnings.push_back(
        error > requested ? "accuracy is " + number_text(requested) + ", but the forces extrapolated from " + grids +
                                ", the finest grids used, have a stated error of " + short_text(error) + "."
                          : "The solvers did not converge on " + grids + ", from which the forces are extrapolated.");
}

}  // namespace

void extrapolate_forces(const ContactProblem& problem, ContactSolution& solution, const SolveOnGrid& solve) {
    if (!problem.accuracy || !problem.friction || !(problem.friction->mu[0] > 0)) return;
    const HertzContact found = hertz_of(problem);
    if (!(found.Fn > 0)) return;
    const ScaledContact contact = scaled(problem, found);
    std::array<Scaled, levels.size()> forces{}, limits{};
    std::array<bool, levels.size()> converged{};
    ForceAccuracy reached;
    std::size_t last = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const Grid grid = grid_of(contact, levels[i].n);
        const ContactSolution on_grid = solve(problem_on(grid, contact));
        forces[i] = {on_grid.forces.Fx, on_grid.forces.Fy, on_grid.forces.Mz};
        converged[i] = on_grid.converged();
        last = i;
        if (i < 1) continue;
        limits[i] = extrapolated(forces[i - 1], forces[i]);
        if (i < 2) continue;
        const auto difference = [&](std::size_t k) { return std::abs(limits[i][k] - limits[i - 1][k]); };
        reached.force_error = std::max(difference(0), difference(1)) + levels[i].force_noise;
        reached.moment_error = difference(2) + levels[i].moment_noise;
        reached.converged = converged[i - 1] && converged[i] && reached.force_error <= *problem.accuracy &&
                            reached.moment_error <= *problem.accuracy;
        const auto& solver = on_grid.evidence.tangential;
        if (reached.converged || (solver && solver->iterations > most_iterations)) break;
    }
    reached.coarse = forces_on(grid_of(contact, levels[last - 1].n), forces[last - 1], contact);
    reached.fine = forces_on(grid_of(contact, levels[last].n), forces[last], contact);
    const GridForces limit = forces_on({}, limits[last], contact);
    solution.forces = {found.Fn, limit.Fx, limit.Fy, limit.Mz};
    const auto& rolling = std::get<Rolling>(problem.motion);
    solution.frictional_power =
        -rolling.velocity * (limit.Fx * rolling.xi + limit.Fy * rolling.eta + limit.Mz * rolling.phi);
    solution.evidence.accuracy = reached;
    if (!reached.converged) warn(reached, *problem.accuracy, solution);
}

}  // namespace contactd

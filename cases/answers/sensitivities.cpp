#include "sensitivities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "closed_forms/undeformed_distance.hpp"
#include "given/not_covered.hpp"

namespace contactd::cases {
namespace {

constexpr double step_size = 1e-4;  // step of differences, relative to the scale of an input
constexpr int inputs = 4;           // the approach, and the motion along x, along y and about z
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

using Outputs = std::array<double, 4>;

/// Returns the problem with the computed approach and motion as inputs, and with tight tolerances.
ContactProblem at_solution(const ContactProblem& problem, const ContactSolution& solution) {
    ContactProblem result = problem;
    if (const auto paraboloid = paraboloid_of(problem)) result.gap = *paraboloid;
    result.Fn.reset();
    result.approach = solution.approach;
    if (solution.motion) result.motion = *solution.motion;
    std::visit([](auto& motion) { motion.force = {}; }, result.motion);
    result.initial = {solution.pressure, solution.traction_x, solution.traction_y};
    result.settings.normal.tolerance = std::min(result.settings.normal.tolerance, 1e-11);
    result.settings.tangential.tolerance = std::min(result.settings.tangential.tolerance, 1e-9);
    result.settings.outer.tolerance = std::min(result.settings.outer.tolerance, 1e-9);
    return result;
}

/// Returns the approach, or one of the three numbers of the motion.
double& input(ContactProblem& problem, int in) {
    if (in == 0) return *problem.approach;
    if (auto* rolling = std::get_if<Rolling>(&problem.motion))
        return in == 1 ? rolling->xi : in == 2 ? rolling->eta : rolling->phi;
    auto& shift = std::get<Shift>(problem.motion);
    return in == 1 ? shift.rigid_shift.x : in == 2 ? shift.rigid_shift.y : shift.rotation;
}

double bound_of(const ContactProblem& problem, const Forces& forces) {
    return problem.friction ? problem.friction->mu_of(0) * forces.Fn : 0;
}

/// Returns the derivative with respect to one of the inputs, or 0 if it has no influence.
double by(const std::optional<DerivativesOfAnswer>& answer, int in) {
    if (!answer) return 0;
    if (in == 0) return answer->approach.value_or(0);
    if (const auto& shift = answer->rigid_shift)
        return in == 1 ? shift->x : in == 2 ? shift->y : answer->rotation.value_or(0);
    return (in == 1 ? answer->xi : in == 2 ? answer->eta : answer->phi).value_or(0);
}

/// Returns the sensitivities, with tangential forces relative to mu Fn, which also changes.
Sensitivities by_derivatives(ContactProblem problem, ContactSolver& solver, bool rubs) {
    Sensitivities result;
    for (auto& row : result) row.fill(nothing);
    problem.derivatives = true;
    const ContactSolution solution = solver.solve(problem);
    if (solution.elements.contact == 0) {
        result[0][0] = 0;
        return result;
    }
    if (!solution.converged() || !solution.derivatives)
        throw NotCovered(Subject::tolerance, "The sensitivities did not reach their tolerance. The forces are valid.");
    const Derivatives& by_all = *solution.derivatives;
    const Forces& forces = solution.forces;
    const double bound = bound_of(problem, forces);
    for (int in = 0; in < (rubs ? inputs : 1); ++in) {
        const double normal = by(by_all.Fn, in);
        result[0][in] = normal;
        if (!rubs) continue;
        result[1][in] = (by(by_all.Fx, in) - forces.Fx / forces.Fn * normal) / bound;
        result[2][in] = (by(by_all.Fy, in) - forces.Fy / forces.Fn * normal) / bound;
        result[3][in] = by(by_all.Mz, in);
    }
    return result;
}

/// Returns the scale of an input: the approach itself, or the motion that produces forces of about mu Fn.
double unit_of(const ContactProblem& problem, const ContactSolution& solution, int in) {
    if (in == 0) return std::abs(solution.approach);
    const double size = std::sqrt(std::max(solution.area.contact, problem.grid.element_area()) / std::numbers::pi);
    const MaterialPair bodies = problem.bodies.materials();
    const double compliance = 0.5 * (1 / bodies.upper.G + 1 / bodies.lower.G);
    const double shift = problem.friction->mu_of(0) * solution.forces.Fn * compliance / size;  // (mm)
    const double along = std::holds_alternative<Rolling>(problem.motion) ? shift / size : shift;
    return in == 3 ? along / size : along;
}

Outputs outputs(const ContactProblem& problem, ContactSolver& solver) {
    const ContactSolution solution = solver.solve(problem);
    if (!solution.converged())
        throw NotCovered(Subject::tolerance,
                         "The solves for the sensitivities did not reach their tolerance. The forces are valid.");
    const Forces& forces = solution.forces;
    const double bound = bound_of(problem, forces);
    const auto relative = [&](double force) { return bound > 0 ? force / bound : 0; };
    return {forces.Fn, relative(forces.Fx), relative(forces.Fy), forces.Mz};
}

Sensitivities by_differences(const ContactProblem& base, const ContactSolution& solution, ContactSolver& solver) {
    Sensitivities result;
    for (auto& row : result) row.fill(nothing);
    for (int in = 0; in < inputs; ++in) {
        const double unit = unit_of(base, solution, in), h = step_size * (unit > 0 ? unit : 1);
        ContactProblem ahead = base, behind = base;
        input(ahead, in) += h;
        input(behind, in) -= h;
        const Outputs more = outputs(ahead, solver), less = outputs(behind, solver);
        for (int out = 0; out < 4; ++out) result[out][in] = (more[out] - less[out]) / (2 * h);
    }
    return result;
}

}  // namespace

Sensitivities sensitivities(const ContactProblem& problem, const ContactSolution& solution, ContactSolver& solver,
                            bool tangential) {
    const bool rubs = tangential && problem.friction && problem.friction->mu_of(0) > 0 && solution.forces.Fn > 0;
    ContactProblem base = at_solution(problem, solution);
    const bool creeps = problem.bodies.any_viscoelastic();
    if (!rubs && !creeps) base.friction.reset();
    // core has no derivatives for slip laws and viscoelastic bodies.
    if (creeps || (rubs && problem.friction->kinetic)) return by_differences(base, solution, solver);
    return by_derivatives(std::move(base), solver, rubs);
}

}  // namespace contactd::cases

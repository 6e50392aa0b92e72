#include "engine/steps/contact_steps.hpp"

#include <format>
#include <string>
#include <utility>

#include "contactd/solve_contact.hpp"
#include "contactd/status.hpp"
#include "engine/ics/problem_tables.hpp"

namespace contactd::engine {
namespace {

/// Names the solvers that missed their tolerance.
StatusError not_converged(const ContactEvidence& evidence) {
    std::string solvers;
    const auto add = [&](const char* name, const std::optional<SolverEvidence>& solver) {
        if (!solver || solver->converged) return;
        solvers += std::format("{}{} after {} iterations at the residual {}", solvers.empty() ? "" : ", ", name,
                               solver->iterations, solver->residual);
    };
    add("normal", evidence.normal);
    add("tangential", evidence.tangential);
    add("outer", evidence.outer);
    add("force", evidence.force);
    return {StatusCode::aborted, reason::not_converged,
            "The step did not converge (" + solvers +
                "), and the session stays where it was: take a smaller step, or open the session with other settings "
                "or with accept_unconverged."};
}

}  // namespace

ContactSteps::ContactSteps(SessionSpec spec, IcAnswers ics, ContactInfluence influence)
    : opened{std::move(spec.setup), std::move(spec.load)},
      accept_unconverged(spec.accept_unconverged),
      ics_(std::move(ics)),
      problem_(opened),
      influence_(std::move(influence)),
      rolling_step_(step_of(opened)) {}

ContactSolution ContactSteps::solve(const StepState& before, const Statement& statement, InfluenceCache& cache,
                                    Observer& observer) {
    problem_.friction = opened.friction;
    problem_.gap = opened.gap;
    problem_.approach = opened.approach;
    problem_.Fn = opened.Fn;
    problem_.motion = opened.motion;
    problem_.rigid_slip = opened.rigid_slip;
    problem_.derivatives = opened.derivatives;
    statement(before.motion, problem_);
    // The quick models know no history and need no estimate.
    if (problem_.model == Model::full) problem_.previous = problem_.initial = before.tractions;
    fit_influence(cache);
    ContactSolution solution = solve_contact(problem_, influence_, observer);
    if (!solution.converged() && !accept_unconverged) throw not_converged(solution.evidence);
    return solution;
}

StepState ContactSteps::after(const StepState& before, ContactSolution&& solution) {
    return {before.step + 1,
            {std::move(solution.pressure), std::move(solution.traction_x), std::move(solution.traction_y)},
            solution.motion};
}

void ContactSteps::fit_influence(InfluenceCache& cache) {
    const auto wanted = step_of(problem_);
    if (problem_.model != Model::full || wanted == std::array<double, 2>{} || wanted == rolling_step_) return;
    validate(problem_);
    influence_ = influence_of(problem_, ics_, cache);
    rolling_step_ = wanted;
}

}  // namespace contactd::engine

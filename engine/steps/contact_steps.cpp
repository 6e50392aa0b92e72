#include "engine/steps/contact_steps.hpp"

#include <utility>

#include "contactd/history.hpp"
#include "contactd/solve_contact.hpp"
#include "engine/ics/problem_tables.hpp"
#include "engine/steps/forces_on_grids.hpp"
#include "engine/steps/not_converged.hpp"

namespace contactd::engine {
namespace {

StatusError not_converged(const ContactEvidence& evidence) {
    MissedTolerances missed;
    missed.add(evidence);
    return missed.error();
}

}  // namespace

ContactSteps::ContactSteps(SessionSpec spec, IcAnswers ics, CachedInfluence influence)
    : opened{std::move(spec.setup), std::move(spec.load)},
      accept_unconverged(spec.accept_unconverged),
      ics_(std::move(ics)),
      problem_(opened),
      influence_(std::move(influence)),
      rolling_step_(rolling_of_operators(opened)) {}

ContactSolution ContactSteps::solve(const StepState& before, const Overlay& overlay, InfluenceCache& cache,
                                    Observer& observer) {
    problem_.friction = opened.friction;
    problem_.gap = opened.gap;
    problem_.approach = opened.approach;
    problem_.Fn = opened.Fn;
    problem_.motion = opened.motion;
    problem_.rigid_slip = opened.rigid_slip;
    problem_.derivatives = opened.derivatives;
    problem_.displacements = opened.displacements;
    overlay(before.motion, problem_);
    // The simplified models have no history and need no estimate.
    if (problem_.model == Model::full) problem_.previous = problem_.initial = before.tractions;
    fit_influence(cache, observer);
    ContactSolution solution = solve_contact(problem_, influence_.influence, observer);
    extrapolate_on_grids(problem_, solution, cache, observer);
    for (std::string& warning : operator_warnings(influence_.use)) solution.warnings.push_back(std::move(warning));
    if (!solution.converged() && !accept_unconverged) throw not_converged(solution.evidence);
    influence_.use.reset();  // is reported once, because the steps keep the operators
    return solution;
}

StepState ContactSteps::after(const StepState& before, ContactSolution&& solution) {
    return {before.step + 1, end_of(std::move(solution)), solution.motion, {}};
}

void ContactSteps::fit_influence(InfluenceCache& cache, const Observer& observer) {
    const auto request = rolling_of_operators(problem_);
    if (problem_.model != Model::full || request == std::array<double, 3>{} || request == rolling_step_) return;
    validate(problem_);
    influence_ = influence_of(problem_, ics_, cache, observer);
    rolling_step_ = request;
}

}  // namespace contactd::engine

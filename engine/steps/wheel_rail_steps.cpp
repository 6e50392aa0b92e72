#include "engine/steps/wheel_rail_steps.hpp"

#include <utility>

#include "engine/steps/not_converged.hpp"

namespace contactd::engine {
namespace {

/// Names the searches and the solvers that missed their tolerance.
StatusError not_converged(const WheelRailSolution& solution) {
    MissedTolerances missed;
    for (const WheelRailPatch& patch : solution.patches) missed.add(patch.solution.evidence);
    missed.add("the search for z", solution.force);
    missed.add("the search for pitch", solution.pitch_search);
    missed.add("the search for the deflection of the rail", solution.rail_search);
    return missed.error();
}

}  // namespace

WheelRailSteps::WheelRailSteps(PreparedContacts::Contact contact, bool accept_unconverged)
    : opened_(std::move(contact)), accept_unconverged_(accept_unconverged) {}

WheelRailSolution WheelRailSteps::solve(const WheelRailContact& contact, const StepState& before,
                                        const WheelRailState& state, StepState& after, Observer& observer) const {
    WheelRailEstimates estimates = before.wheel_rail;
    WheelRailSolution solution = contact.solve(state, estimates, observer);
    if (!solution.converged() && !accept_unconverged_) throw not_converged(solution);
    after = {before.step + 1, {}, {}, std::move(estimates)};
    return solution;
}

const WheelRailContact& WheelRailSteps::contact_with(const std::optional<WheelRailFriction>& friction) {
    if (!friction || friction == setup().friction) return *opened_;
    if (!other_friction_ || other_friction_->setup().friction != friction)
        other_friction_ = opened_->with_friction(*friction);
    return *other_friction_;
}

}  // namespace contactd::engine

#include "contactd/error.hpp"
#include "engine/steps/contact_steps.hpp"

namespace contactd::engine {
namespace {

/// Takes over the motion that the previous step found for a prescribed force.
void take_estimates(const Motion& last, Motion& motion) {
    const auto* before = std::get_if<Rolling>(&last);
    auto* rolling = std::get_if<Rolling>(&motion);
    if (!before || !rolling) return;
    if (before->force.Fx && rolling->force.Fx) rolling->xi = before->xi;
    if (before->force.Fy && rolling->force.Fy) rolling->eta = before->eta;
}

void overlay_load(const StepInput& input, ContactProblem& problem) {
    if (input.approach && input.Fn)
        throw InvalidArgument("Fn", "cannot be combined with an approach; remove one of them");
    if (input.approach || input.Fn) {
        problem.approach = input.approach;
        problem.Fn = input.Fn;
    } else if (!problem.approach && !problem.Fn) {
        throw InvalidArgument("approach", "is missing; give it or Fn in every step, because the opening gave neither");
    }
}

void overlay_friction(const StepInput& input, ContactProblem& problem) {
    if (!input.friction && !input.motion && input.rigid_slip.empty()) return;
    if (!problem.friction && !input.friction)
        throw InvalidArgument("friction.mu",
                              "is missing; give it in every step with friction, because the opening gave none");
    if (input.friction) {
        const FrictionLaw opened = problem.friction.value_or(FrictionLaw{});
        problem.friction = input.friction;
        if (!problem.friction->kinetic) problem.friction->kinetic = opened.kinetic;
        if (!problem.friction->layer) problem.friction->layer = opened.layer;
        if (!problem.friction->temperature) problem.friction->temperature = opened.temperature;
    }
    if (input.motion) problem.motion = *input.motion;
    if (!input.rigid_slip.empty()) problem.rigid_slip = input.rigid_slip;
}

}  // namespace

void overlay(const StepInput& input, const std::optional<Motion>& last, ContactProblem& problem) {
    overlay_load(input, problem);
    if (input.gap)
        problem.gap = input.gap;
    else if (!problem.gap)
        throw InvalidArgument("gap", "is missing; give it in every step, because the opening gave none");
    overlay_friction(input, problem);
    if (input.derivatives) problem.derivatives = *input.derivatives;
    if (input.displacements) problem.displacements = *input.displacements;
    if (last && problem.friction && !input.motion) take_estimates(*last, problem.motion);
}

}  // namespace contactd::engine

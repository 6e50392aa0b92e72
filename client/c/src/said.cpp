#include "said.hpp"

#include <string>

#include "contactd/error.hpp"

namespace contactd::c {
namespace {

/// The coefficients of a body, where they are to be made: its material is called as in a problem.
void validate_coefficients(const ContactSetup& setup, const Body& body, const std::string& name) {
    const Ics* ics = body.computed();
    if (ics == nullptr) return;
    const Grid& grid = setup.grid;
    validate(IcSpec{*ics, body.material, grid.dx, grid.dy, grid.nx, grid.ny}, name);
}

}  // namespace

const ContactProblem& Said::stated() {
    if (mu.empty() && (kind || kinetic || !force.empty() || !problem.rigid_slip.empty()))
        throw InvalidArgument("friction.mu", "is missing; what moves the bodies means nothing without friction");
    problem.friction.reset();
    if (!mu.empty()) problem.friction = FrictionLaw{mu, kinetic};
    shift.force = rolling.force = force;
    if (kind.value_or(MotionKind::shift) == MotionKind::rolling)
        problem.motion = rolling;
    else
        problem.motion = shift;
    return problem;
}

SessionSpec Said::opening() {
    SessionSpec spec{stated(), problem, lease_seconds, accept_unconverged};
    validate_opening(problem);
    if (problem.model == Model::full && !problem.bodies.pair) {
        validate_coefficients(problem, problem.bodies.upper, "bodies.upper");
        validate_coefficients(problem, problem.bodies.lower, "bodies.lower");
    }
    return spec;
}

StepInput Said::step() {
    validate(stated());
    StepInput input;
    input.approach = problem.approach;
    input.Fn = problem.Fn;
    if (changed.gap) input.gap = problem.gap;
    if (changed.friction) input.friction = problem.friction;
    if (changed.motion) input.motion = problem.motion;
    if (changed.rigid_slip) input.rigid_slip = problem.rigid_slip;
    input.fields = fields;
    input.derivatives = derivatives;
    return input;
}

void Said::take_estimates(const std::optional<Motion>& found) {
    if (!found || !changed.motion || kind != MotionKind::rolling) return;
    const auto* motion = std::get_if<Rolling>(&*found);
    if (motion == nullptr) return;
    if (force.Fx && motion->force.Fx) rolling.xi = motion->xi;
    if (force.Fy && motion->force.Fy) rolling.eta = motion->eta;
}

}  // namespace contactd::c

#include "wheel_rail/patch_derivatives.hpp"

#include <utility>

#include "wheel_rail/right_wheel.hpp"

namespace contactd {
namespace {

/// Returns whether pressures are known not to depend on tractions.
bool is_uncoupled(const Bodies& bodies) {
    const auto is_half_space = [](const Body& body) {
        return body.material.is_rigid() ||
               (body.computed() != nullptr && body.computed()->source == IcSource::analytic);
    };
    return bodies.materials().quasi_identical() && is_half_space(bodies.upper) && is_half_space(bodies.lower) &&
           !bodies.any_given() && !bodies.any_layered() && !bodies.any_uniform();
}

bool has_pressure_derivatives(const WheelRailSetup& setup) {
    return setup.model == Model::full && setup.normal_model == NormalModel::of_model &&
           !setup.bodies.any_viscoelastic();
}

}  // namespace

bool acts_through_creepages(const WheelRailSetup& setup, const WheelRailState& state) {
    if (!setup.friction || state.motion != WheelRailMotion::steady_rolling) return false;
    const WheelRailFriction& friction = *setup.friction;
    if (friction.layer && friction.layer->yields()) return false;
    return !friction.kinetic && !friction.follows_temperature() && setup.rigid_slip == RigidSlipKind::plane &&
           setup.conformal == Conformal::off;
}

// Patches are solved again on their own elements, because those of candidates at this height may differ.
void differentiate_pressures(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer) {
    const WheelRailSetup& setup = wheel.setup();
    if (!has_pressure_derivatives(setup)) return;
    const bool is_normal = !setup.friction || is_uncoupled(setup.bodies);
    if (!is_normal && !acts_through_creepages(setup, wheel.state())) return;
    for (WheelRailPatch& patch : solution.patches) {
        if (!patch.place.rows.empty()) continue;
        geometry::CandidatePatch found;
        found.place = patch.place;
        found.gap = patch.gap;
        ContactProblem problem = wheel.problem_of(found);
        if (is_normal) problem.friction.reset();
        problem.temperature.reset();
        problem.wear.reset();
        problem.approach = patch.solution.approach;
        problem.initial.pressure = patch.solution.pressure;
        problem.derivatives = true;
        ContactSolution differentiated = wheel.solve(std::move(problem), found, observer);
        patch.solution.pressure_by_approach = std::move(differentiated.pressure_by_approach);
    }
}

}  // namespace contactd

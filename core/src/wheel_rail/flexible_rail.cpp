#include "wheel_rail/flexible_rail.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "wheel_rail/condense.hpp"
#include "wheel_rail/differentiate.hpp"
#include "wheel_rail/right_wheel.hpp"

namespace contactd {
namespace {

/// Returns the deflection of a spring; that of a rigid rail is zero.
double deflection_by(double force, const std::optional<double>& stiffness) {
    return stiffness ? force / *stiffness : 0;
}

}  // namespace

WheelRailState deflected(WheelRailState state, const RailDeflection& deflection) {
    state.rail.y += deflection.y;
    state.rail.z += deflection.z;
    state.rail.Fy = state.rail.Fz = 0;
    state.Fx.reset();
    state.derivatives = false;
    return state;
}

std::optional<HeightTask> height_over_rail(RightWheel& unloaded, const WheelRailState& given, double stiffness) {
    if (!unloaded.first_contact_height()) return std::nullopt;
    HeightTask task = unloaded.height_task(0);
    task.target = stiffness * (given.position.height() - task.first_contact_height) - given.rail.Fz;
    if (!(task.target > 0)) return std::nullopt;
    task.spring = stiffness;
    task.deepest = task.first_contact_height + std::min(deepest_penetration, task.target / stiffness);
    return task;
}

void differentiate_on_flexible_rail(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer) {
    const WheelRailSetup setup = with_fixed_rail(wheel.setup());
    const WheelRailState state = deflected(wheel.state(), *solution.rail_deflection);
    RightWheel on_fixed_rail = wheel.with(setup, state);
    differentiate(on_fixed_rail, solution, observer);
    if (solution.derivatives)
        condense_rail_deflection(*solution.derivatives, solution.forces.track, *wheel.setup().track.springs);
}

WheelRailSetup with_fixed_rail(WheelRailSetup setup) {
    setup.track.springs.reset();
    setup.fatigue.reset();  // Fatigue is computed once, for the final position of the rail.
    return setup;
}

WheelRailState expected_on_flexible_rail(const RightWheel& wheel) {
    const WheelRailState& given = wheel.state();
    const RailSprings& springs = *wheel.setup().track.springs;
    RailDeflection deflection{deflection_by(given.rail.Fy, springs.y),
                              deflection_by(given.rail.Fz + given.Fz.value_or(0), springs.z)};
    if (given.Fz || !springs.z) return deflected(given, deflection);
    const WheelRailSetup setup = with_fixed_rail(wheel.setup());
    const WheelRailState unloaded = deflected(given, {deflection.y, 0});
    RightWheel on_fixed_rail = wheel.with(setup, unloaded);
    if (const auto task = height_over_rail(on_fixed_rail, given, *springs.z))
        deflection.z = given.position.height() - find_height(*task).z;
    return deflected(given, deflection);
}

double rolling_pitch_rate(const WheelRailSetup& setup, const WheelRailState& state) {
    const double speed = setup.track.roller_radius ? state.roller_pitch * *setup.track.roller_radius : state.velocity.x;
    return -speed / setup.wheelset.nominal_radius;
}

}  // namespace contactd

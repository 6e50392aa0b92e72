// Creates random positions of wheels on rails, including measured profiles, and checks properties of every answer.
#pragma once

#include <cmath>
#include <string>

#include "contact/random_problems.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/solve_wheel_rail.hpp"

namespace contactd::test {

struct RandomWheelRail {
    WheelRailSetup setup;
    WheelRailState state;
};

/// Returns the profile as an instrument would measure it: points about 0.5 mm apart, and noise.
inline ProfileSpec measured(Dice& dice, const ProfileSpec& profile) {
    const ProfileCurve curve = make_profile(profile).curve;
    ProfilePoints points;
    const double spacing = dice.uniform(0.3, 0.8), noise = dice.chance(0.2) ? 0 : dice.log_uniform(1e-3, 0.05);
    for (double s = dice.uniform(0, 3); s < curve.end(); s += spacing) {
        const ProfilePoint at = curve.at(s);
        points.points.push_back({at.y + noise * dice.uniform(-1, 1), at.z + noise * dice.uniform(-1, 1)});
    }
    if (!dice.chance(0.3)) points.smoothing_length = dice.uniform(2, 6);
    return {profile.kind, points};
}

/// Moves the rail's points from slice to slice.
inline void slice(Dice& dice, WheelRailSetup& setup) {
    const ProfileCurve curve = make_profile(setup.rail).curve;
    setup.track.roller_radius.reset();
    setup.track.rail_origin = ProfilePoint{760, dice.uniform(-1, 1)};
    for (double x = -600; x <= 600; x += dice.uniform(100, 500)) {
        const double y = dice.uniform(-2, 2), z = dice.uniform(-1, 1);
        ProfilePoints points;
        for (const ProfilePoint& point : curve.points()) points.points.push_back({point.y + y, point.z + z});
        setup.rail_slices.push_back({x, {ProfileKind::rail, points}});
    }
}

/// Changes the wheel's points by up to half a millimetre from angle to angle: out of round, and flats.
inline void flatten(Dice& dice, WheelRailSetup& setup) {
    const ProfileCurve curve = make_profile(setup.wheel).curve;
    for (double angle = 0.1; angle < 6.2; angle += dice.uniform(0.2, 2)) {
        const double z = dice.chance(0.3) ? 0 : dice.uniform(-0.5, 0.5);
        ProfilePoints points;
        for (const ProfilePoint& point : curve.points()) points.points.push_back({point.y, point.z + z});
        setup.wheel_slices.push_back({angle, {ProfileKind::wheel, points}});
    }
}

inline RailSprings random_springs(Dice& dice) {
    RailSprings springs;
    if (dice.chance(0.8)) springs.y = dice.log_uniform(1e4, 1e7);
    if (!springs.y || dice.chance(0.8)) springs.z = dice.log_uniform(3e4, 1e7);
    return springs;
}

/// `dx` is the smallest of the elements.
inline WheelRailSetup random_setup(Dice& dice, double dx) {
    WheelRailSetup setup;
    setup.side = dice.chance(0.5) ? Side::left : Side::right;
    setup.rail.shape = Rail60E1{dice.chance(0.5) ? 1.0 / 40 : 1.0 / 20};
    if (dice.chance(0.5)) setup.wheel = measured(dice, setup.wheel);
    if (dice.chance(0.5)) setup.rail = measured(dice, setup.rail);
    if (dice.chance(0.3)) setup.track.cant = dice.uniform(-0.02, 0.03);
    if (dice.chance(0.2)) setup.track.gauge = dice.uniform(1425, 1450);
    if (dice.chance(0.2)) setup.track.roller_radius = dice.log_uniform(200, 3000);
    if (dice.chance(0.2)) setup.wheelset.nominal_radius = dice.uniform(300, 600);
    setup.dx = dx * dice.log_uniform(1, 3);
    setup.dy = setup.dx * dice.log_uniform(0.5, 2);
    if (dice.chance(0.3)) setup.model = dice.chance(0.5) ? Model::hertz : Model::fastsim;
    if (setup.model == Model::hertz || dice.chance(0.2))
        setup.friction.reset();
    else if (dice.chance(0.3))
        setup.friction =
            WheelRailFriction{{{-0.8, 0.1}, {-0.2, 0.35}}, setup.model == Model::full && dice.chance(0.5), {}};
    if (setup.model == Model::full && dice.chance(0.2)) setup.rigid_slip = RigidSlipKind::surfaces;
    if (dice.chance(0.1)) slice(dice, setup);
    if (dice.chance(setup.rail_slices.empty() ? 0.1 : 0.5)) setup.patches.search = ContactSearch::mesh;
    if (setup.model == Model::full && dice.chance(0.2))
        setup.conformal = setup.friction ? Conformal::rotated : Conformal::half_space;
    if (dice.chance(0.1)) flatten(dice, setup);
    if (dice.chance(0.15)) setup.track.springs = random_springs(dice);
    return setup;
}

/// Chooses y up to 15 mm, roll and yaw up to 30 mrad. The height is prescribed near the first contact, or determined by
/// the force.
inline WheelRailState random_state(Dice& dice, const WheelRailContact& contact) {
    WheelRailState state;
    state.position = {dice.uniform(-15, 15), 0, dice.uniform(-0.03, 0.03), dice.uniform(-0.03, 0.03)};
    if (dice.chance(0.3)) state.rail = {dice.uniform(-3, 3), dice.uniform(-2, 2), dice.uniform(-0.01, 0.01)};
    state.velocity.x = dice.chance(0.1) ? 0 : dice.uniform(-6e4, 6e4);
    state.velocity.pitch = -state.velocity.x / contact.setup().wheelset.nominal_radius * dice.uniform(0.95, 1.05);
    state.velocity.y = dice.uniform(-100, 100);
    state.velocity.yaw = dice.uniform(-0.1, 0.1);
    state.roller_pitch = state.velocity.x / contact.setup().track.roller_radius.value_or(500);
    if (contact.setup().track.roller_radius) state.velocity.x = 0;
    state.position.x = dice.uniform(-500, 500);
    state.position.pitch = dice.uniform(-20, 20);
    const RailSprings springs = contact.setup().track.springs.value_or(RailSprings());
    if (springs.y && dice.chance(0.3)) state.rail.Fy = dice.uniform(-1e4, 1e4);
    if (springs.z && dice.chance(0.3)) state.rail.Fz = dice.uniform(-1e4, 1e4);
    state.derivatives = dice.chance(0.05);
    if (dice.chance(0.5))
        state.Fz = dice.log_uniform(10, 3e5);
    else if (const auto height = contact.first_contact_height(state))
        state.position.z = *height + dice.uniform(-0.05, 0.15);
    const bool rolls = state.velocity.x != 0 || state.roller_pitch != 0;
    if (state.Fz && rolls && contact.setup().friction && dice.chance(0.1))
        state.Fx = dice.uniform(-0.4, 0.4) * *state.Fz;
    return state;
}

/// Sums forces of tractions, in track coordinates.
inline Wrench summed_tractions(const WheelRailPatch& patch) {
    const ContactSolution& solution = patch.solution;
    const ContactPlace& place = patch.place;
    const double area = place.grid.element_area();
    Wrench sum;
    for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
        const double angle =
            place.rows.empty() ? place.reference.angle : place.rows[i / static_cast<std::size_t>(place.grid.nx)].angle;
        const double y = solution.traction_y.empty() ? 0 : solution.traction_y[i], n = solution.pressure[i];
        sum.Fx += area * (solution.traction_x.empty() ? 0 : solution.traction_x[i]);
        sum.Fy += area * (y * std::cos(angle) - n * std::sin(angle));
        sum.Fz += area * (y * std::sin(angle) + n * std::cos(angle));
    }
    return sum;
}

/// Returns the errors in an answer; empty if there are none.
inline std::string wheel_rail_faults(const RandomWheelRail& problem, const WheelRailSolution& solution) {
    if (solution.patches.empty()) {
        if (problem.state.Fz && solution.warnings.empty()) return "no contact under a force, and no word about it";
        if (solution.clearance && *solution.clearance < 0) return "no contact where profiles overlap";
        return {};
    }
    if (!solution.converged() && solution.warnings.empty()) return "not converged, and no word about it";
    if (!solution.converged()) return {};
    Wrench sum;
    for (const WheelRailPatch& patch : solution.patches) {
        const Wrench part = summed_tractions(patch);
        sum.Fx += part.Fx;
        sum.Fy += part.Fy;
        sum.Fz += part.Fz;
    }
    const Wrench& stated = solution.forces.track;
    // On a rail that slopes along the track, pressures have a component along it, unlike their sum on level planes.
    const bool slopes = problem.setup.track.roller_radius || !problem.setup.rail_slices.empty();
    const double off = std::hypot(slopes ? 0 : sum.Fx - stated.Fx, sum.Fy - stated.Fy, sum.Fz - stated.Fz);
    if (problem.setup.model == Model::full && !(off <= 1e-10 * std::hypot(stated.Fx, stated.Fy, stated.Fz)))
        return "tractions do not sum to the forces";
    if (problem.state.Fz && !(std::abs(stated.Fz - *problem.state.Fz) <= 1e-6 * *problem.state.Fz))
        return "Fz is not the one prescribed";
    const auto magnitude = [](const Wrench& w) { return std::hypot(w.Fx, w.Fy, w.Fz); };
    const double size = magnitude(stated);
    if (!(std::abs(magnitude(solution.forces.rail) - size) <= 1e-10 * size &&
          std::abs(magnitude(solution.forces.wheelset) - size) <= 1e-10 * size))
        return "forces differ from coordinates to coordinates";
    return {};
}

}  // namespace contactd::test

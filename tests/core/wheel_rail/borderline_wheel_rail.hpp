// Creates random wheels on rails at the limits of valid input: profiles of a few points, tiny and huge values. Each has
// an answer or a refusal, and a refusal names an input.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/error.hpp"
#include "wheel_rail/random_wheel_rail.hpp"

namespace contactd::test {

template <class Value, std::size_t count>
Value one_of(Dice& dice, const std::array<Value, count>& values) {
    return values[static_cast<std::size_t>(dice.integer(0, static_cast<int>(count) - 1))];
}

/// Returns zero, or a number so small that products underflow, of both signs.
inline double next_to_nothing(Dice& dice) {
    return one_of(dice, std::array{0.0, 5e-324, 1e-300, 1e-100, 1e-20, 1e-9}) * (dice.chance(0.5) ? 1 : -1);
}

/// Creates a parabola with few points at random places, some of them off it.
inline ProfileSpec few_points(Dice& dice, ProfileKind kind) {
    const double half = dice.log_uniform(1, 60), radius = dice.log_uniform(5, 1000);
    const double noise = dice.chance(0.5) ? 0 : dice.log_uniform(1e-3, 2), sign = kind == ProfileKind::rail ? 1 : -0.3;
    std::vector<double> places;
    for (int i = dice.integer(2, 20); i > 0; --i) places.push_back(dice.uniform(-half, half));
    std::sort(places.begin(), places.end());
    ProfilePoints points;
    for (const double y : places)
        points.points.push_back({y, sign * y * y / (2 * radius) + noise * dice.uniform(-1, 1)});
    return {kind, points};
}

inline WheelRailSetup borderline_setup(Dice& dice) {
    WheelRailSetup setup = random_setup(dice, 0.5);
    setup.rail_slices.clear();
    setup.wheel_slices.clear();
    if (dice.chance(0.3)) setup.rail = few_points(dice, ProfileKind::rail);
    if (dice.chance(0.3)) setup.wheel = few_points(dice, ProfileKind::wheel);
    if (dice.chance(0.2)) setup.wheel.shape = ConeProfile{one_of(dice, std::array{0.0, -0.05, 0.5, 1e-9}), -60, 60};
    if (dice.chance(0.2)) setup.rail.shape = ArcProfile{dice.log_uniform(40, 1000), 0, -20, 20};
    if (dice.chance(0.3)) setup.track.rail_origin = ProfilePoint{one_of(dice, std::array{750.0, 717.5, 0.0}), 0};
    if (dice.chance(0.2)) setup.track.gauge_height = one_of(dice, std::array{0.0, 1.0, 100.0, 1e4});
    if (dice.chance(0.1)) setup.track.roller_radius = one_of(dice, std::array{1.0, 10.0, 1e4});
    if (dice.chance(0.1)) setup.track.springs = RailSprings{.z = one_of(dice, std::array{1e-3, 1.0, 1e10})};
    if (dice.chance(0.1)) setup.wheelset.nominal_radius = one_of(dice, std::array{60.0, 1e4});
    if (dice.chance(0.3)) setup.dx = one_of(dice, std::array{2.0, 5.0});
    if (dice.chance(0.3)) setup.dy = one_of(dice, std::array{2.0, 5.0});
    if (dice.chance(0.2)) setup.dq = one_of(dice, std::array{5e-324, 1e-9, 100.0});
    if (dice.chance(0.2) && setup.friction) setup.friction->mu = {{0, one_of(dice, std::array{0.0, 5e-324, 1e3})}};
    if (dice.chance(0.3)) setup.friction = WheelRailFriction{};
    setup.rail_slices.clear();
    return setup;
}

inline WheelRailState borderline_state(Dice& dice, const WheelRailContact& contact) {
    WheelRailState state = random_state(dice, contact);
    const auto extreme = [&](double largest) {
        return dice.chance(0.5) ? next_to_nothing(dice) : dice.chance(0.5) ? largest : -largest;
    };
    for (double* angle : {&state.position.roll, &state.position.yaw})
        if (dice.chance(0.2)) *angle = extreme(0.5);
    const auto far = [&] { return dice.chance(0.5) ? dice.uniform(-15, 15) : extreme(1e4); };
    if (dice.chance(0.2)) state.position.y = far();
    if (dice.chance(0.2)) state.position.z = far();
    auto& [x, y, z, roll, yaw, pitch] = state.velocity;
    for (double* velocity : {&x, &y, &z, &roll, &yaw, &pitch})
        if (dice.chance(0.2)) *velocity = extreme(1e9);
    if (dice.chance(0.2)) state.Fz = one_of(dice, std::array{1e-6, 1e-3, 1.0, 1e6});
    if (state.Fx && x == 0 && state.roller_pitch == 0) state.Fx.reset();
    state.derivatives = dice.chance(0.1);
    return state;
}

/// Returns whether a set-up or a state has such a field; fields of the problems of patches are not inputs.
inline bool is_given(std::string_view field) {
    for (const std::string_view patch : {"friction.rolling", "friction.rigid", "friction.rotation", "friction.force"})
        if (field.starts_with(patch)) return false;
    for (const std::string_view part : {"side", "wheel", "rail", "track", "bodies", "model", "friction", "dx", "dy",
                                        "dq", "patches", "rigid_slip", "settings", "conformal", "force", "state."})
        if (field.starts_with(part)) return true;
    return false;
}

/// Checks that all numbers of the answer are finite; others would be internal errors.
inline bool is_finite(const WheelRailSolution& solution) {
    const auto fine = [](std::initializer_list<double> values) {
        return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    };
    const auto wrench = [&](const Wrench& w) { return fine({w.Fx, w.Fy, w.Fz, w.Mx, w.My, w.Mz}); };
    for (const WheelRailPatch& patch : solution.patches) {
        const ContactReference& reference = patch.place.reference;
        const Grid& grid = patch.place.grid;
        const Creepages& creepages = patch.place.creepages;
        const ContactSolution& found = patch.solution;
        if (!fine({reference.x,
                   reference.y,
                   reference.z,
                   reference.angle,
                   grid.x0,
                   grid.y0,
                   patch.place.approach,
                   patch.place.penetration,
                   creepages.xi,
                   creepages.eta,
                   creepages.phi,
                   creepages.velocity,
                   found.approach,
                   found.forces.Fn,
                   found.forces.Fx,
                   found.forces.Fy,
                   found.forces.Mz,
                   found.pmax,
                   found.area.contact,
                   found.area.adhesion,
                   found.area.slip,
                   found.frictional_power.value_or(0)}) ||
            !wrench(patch.forces.track))
            return false;
        for (const auto* values : {&found.pressure, &found.traction_x, &found.traction_y, &found.slip_x, &found.slip_y})
            for (const double value : *values)
                if (!std::isfinite(value)) return false;
    }
    const WheelRailForces& forces = solution.forces;
    for (const auto& search : {solution.force, solution.pitch_search, solution.rail_search})
        if (search && !std::isfinite(search->residual)) return false;
    return fine({solution.z, solution.pitch_rate, solution.clearance.value_or(0)}) && wrench(forces.track) &&
           wrench(forces.rail) && wrench(forces.wheelset);
}

/// Ends long computations, because searches at the limits of valid input may take long.
class Impatient final : public Observer {
   public:
    bool cancelled() const override { return ++looks_ > most; }

   private:
    static constexpr int most = 3000;
    mutable int looks_ = 0;
};

/// Returns the errors in the result of a borderline wheel, which must be an encodable answer or a refusal of an input.
inline std::string borderline_fault(std::uint64_t seed) {
    Dice dice(seed);
    Impatient observer;
    try {
        const WheelRailContact contact(borderline_setup(dice));
        const WheelRailState state = borderline_state(dice, contact);
        const WheelRailGeometry geometry = contact.locate(state);
        if (!std::isfinite(geometry.z)) return "the geometry has no height";
        const WheelRailSolution solution = contact.solve(state, observer);
        if (!is_finite(solution)) return "the answer is not finite";
        if (!solution.converged() && solution.warnings.empty()) return "not converged, and no word about it";
    } catch (const InvalidArgument& error) {
        if (!is_given(error.field())) return std::string("nobody gave ") + error.what();
    } catch (const Cancelled&) {
        return {};
    } catch (const std::exception& error) {
        return std::string("an error of the program: ") + error.what();
    }
    return {};
}

}  // namespace contactd::test

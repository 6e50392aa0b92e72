// Tests temperatures of wheels and rails: each surface passes through the contact at its own speed, for every kind of
// slip.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "closed_forms/hertz.hpp"
#include "contactd/surface_temperature.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double steel = 13.290033860;  // effusivity (N/(mm s^0.5 K))
constexpr double velocity = 20000, radius = 450, mu = 0.3, load = 40000;
constexpr double of_band = 2.188306674;  // largest value of Hertz's strip (Carslaw and Jaeger, section 2.9)

/// Creates a cylinder on an arc, whose slip is that of a plane motion, of elements, or of the rows of a curved contact.
WheelRailSetup hot(RigidSlipKind slip, Conformal conformal) {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 0.2;
    setup.rigid_slip = slip;
    setup.conformal = conformal;
    setup.friction = WheelRailFriction{{{0, mu}}};
    setup.temperature = ThermalBodies{};
    return setup;
}

/// Creates a wheel whose rim is faster than the track by `slip` times its speed.
WheelRailState sliding(double slip, double forwards = velocity) {
    WheelRailState state;
    state.velocity.x = forwards;
    state.velocity.pitch = -forwards * (1 + slip) / radius;
    state.Fz = load;
    return state;
}

ContactSolution patch_of(const WheelRailSetup& setup, const WheelRailState& state) {
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.converged());
    REQUIRE(solution.patches.size() == 1);
    return solution.patches[0].solution;
}

ContactTemperature temperature_of(const WheelRailSetup& setup, const WheelRailState& state) {
    return patch_of(setup, state).temperature.value();
}

/// Lists kinds of slip: of the plane, of rows, of elements, and of curved contacts.
std::pair<RigidSlipKind, Conformal> any_slip() {
    return GENERATE(std::pair(RigidSlipKind::plane, Conformal::off), std::pair(RigidSlipKind::surfaces, Conformal::off),
                    std::pair(RigidSlipKind::elements, Conformal::off),
                    std::pair(RigidSlipKind::plane, Conformal::half_space),
                    std::pair(RigidSlipKind::plane, Conformal::rotated));
}

}  // namespace

TEST_CASE("A wheel that slides is as hot as a Hertzian strip between surfaces of both speeds", "[temperature]") {
    const auto [kind, conformal] = any_slip();
    const double slip = GENERATE(-0.3, 0.3, -0.8, 1.0);
    CAPTURE(kind, conformal, slip);
    const ContactTemperature found = temperature_of(hot(kind, conformal), sliding(slip));
    const HertzContact hertz = hertz_of_force({radius, 300}, 2 * (1 - 0.28) / (2 * 82000), load);
    const double roots = steel * (std::sqrt(velocity) + std::sqrt(velocity * (1 + slip)));
    const double heat = mu * hertz.pmax * std::abs(slip) * velocity;
    CHECK_THAT(found.rise, WithinRel(heat * std::sqrt(hertz.a / std::numbers::pi) * of_band / roots, 0.01));
    CHECK_THAT(found.heat_upper / (found.heat_upper + found.heat_lower),
               WithinAbs(steel * std::sqrt(velocity) / roots, 1e-3));
}

TEST_CASE("A contact that is hardly curved is as hot as a plane one, with spin, too", "[temperature]") {
    const RigidSlipKind kind = GENERATE(RigidSlipKind::surfaces, RigidSlipKind::elements);
    WheelRailState state = sliding(-0.2);
    state.wheel.yaw_velocity = 200;  // about the contact: a spin of 0.01 rad/mm
    const WheelRailSetup plane = hot(RigidSlipKind::plane, Conformal::off);
    const ContactTemperature of_plane = temperature_of(plane, state);
    CHECK_THAT(temperature_of(hot(kind, Conformal::off), state).rise, WithinRel(of_plane.rise, 5e-3));
    const ContactTemperature curved = temperature_of(hot(RigidSlipKind::plane, Conformal::half_space), state);
    CHECK_THAT(curved.rise, WithinRel(of_plane.rise, 5e-3));
    CHECK_THAT(curved.heat_upper, WithinRel(of_plane.heat_upper, 5e-3));
    CHECK_THAT(curved.heat_lower, WithinRel(of_plane.heat_lower, 5e-3));
}

TEST_CASE("The rail passes all rows at the speed of the contact, and the wheel by the slip of the row beside it",
          "[temperature]") {
    WheelRailSetup setup = hot(RigidSlipKind::plane, GENERATE(Conformal::off, Conformal::half_space));
    WheelRailState state = sliding(-0.2);
    state.wheel.yaw_velocity = 300;
    const WheelRailSolution whole = solve(setup, state);
    REQUIRE(whole.converged());
    const ContactSolution& solution = whole.patches.at(0).solution;
    REQUIRE(solution.upper_speed.has_value());
    const Grid grid = whole.patches[0].place.grid;
    const double V = std::get<Rolling>(*solution.motion).velocity;
    const auto nx = static_cast<std::size_t>(grid.nx);
    double fastest = 0, slowest = 1e9;
    for (std::size_t row = 0; row < static_cast<std::size_t>(grid.ny); ++row) {
        double pressure = 0, slip = 0;
        for (std::size_t i = row * nx; i < (row + 1) * nx; ++i) {
            pressure += solution.pressure[i];
            slip += solution.pressure[i] * solution.slip_x[i];
        }
        if (!(pressure > 0)) continue;
        const double wheel = *solution.upper_speed + V * slip / pressure;
        fastest = std::max(fastest, wheel);
        slowest = std::min(slowest, wheel);
        // Sums the heat of all elements ahead from the leading edge on, by Blok's band sources.
        for (std::size_t ix = 0; ix < nx; ++ix) {
            const std::size_t i = row * nx + ix;
            if (!(solution.pressure[i] > 0)) continue;
            double sum = 0;
            for (std::size_t ahead = ix; ahead < nx; ++ahead) {
                const std::size_t j = row * nx + ahead;
                const double heat =
                    -V * (solution.traction_x[j] * solution.slip_x[j] + solution.traction_y[j] * solution.slip_y[j]);
                const double distance = static_cast<double>(ahead - ix) * grid.dx;
                sum += std::max(heat, 0.0) *
                       (std::sqrt(distance + grid.dx / 2) - std::sqrt(std::max(0.0, distance - grid.dx / 2)));
            }
            const double roots = steel * (std::sqrt(*solution.upper_speed) + std::sqrt(wheel));
            CHECK_THAT(solution.upper_temperature[i],
                       WithinRel(2 * sum / (roots * std::sqrt(std::numbers::pi)), 1e-8) || WithinAbs(0, 1e-9));
        }
    }
    CHECK(fastest > 1.1 * slowest);
}

TEST_CASE("The rail's speed is that of the contact along it, and of a roller that of its surface", "[temperature]") {
    const auto [kind, conformal] = any_slip();
    CAPTURE(kind, conformal);
    const double forwards = GENERATE(velocity, -velocity);
    WheelRailSetup setup = hot(kind, conformal);
    const ContactSolution on_rail = patch_of(setup, sliding(-0.3, forwards));
    CHECK_THAT(on_rail.upper_speed.value(), WithinRel(velocity, 1e-12));
    setup.track.roller_radius = 1e6;
    WheelRailState rolling = sliding(-0.3, forwards);
    rolling.velocity.x = 0;
    rolling.roller_pitch = forwards / 1e6;
    const ContactSolution on_roller = patch_of(setup, rolling);
    CHECK_THAT(on_roller.upper_speed.value(), WithinRel(velocity, 1e-4));
    CHECK_THAT(on_roller.temperature->rise, WithinRel(on_rail.temperature->rise, 2e-3));
    CHECK_THAT(on_roller.temperature->heat_lower, WithinRel(on_rail.temperature->heat_lower, 2e-3));
}

TEST_CASE("A locked wheel gives its heat to the rail, and a rail where a wheel spins on the spot to the wheel",
          "[temperature]") {
    const auto [kind, conformal] = any_slip();
    CAPTURE(kind, conformal);
    const WheelRailSetup setup = hot(kind, conformal);
    const ContactTemperature locked = temperature_of(setup, sliding(-1));
    CHECK(locked.heat_upper > 0.98 * (locked.heat_upper + locked.heat_lower));
    WheelRailState spins = sliding(0);
    spins.velocity.x = 0;
    const ContactTemperature spinning = temperature_of(setup, spins);
    CHECK(spinning.heat_lower > 0.98 * (spinning.heat_upper + spinning.heat_lower));
}

TEST_CASE("Temperatures of a left wheel are those of a right one in a mirror, and of the way back those of the way",
          "[temperature]") {
    const auto [kind, conformal] = any_slip();
    CAPTURE(kind, conformal);
    WheelRailSetup setup = hot(kind, conformal);
    const WheelRailState state = sliding(-0.3);
    const ContactSolution right = patch_of(setup, state);
    CHECK_THAT(patch_of(setup, sliding(-0.3, -velocity)).temperature->rise, WithinRel(right.temperature->rise, 1e-5));
    setup.side = Side::left;
    const WheelRailSolution left = mirrored(solve(setup, mirrored(state)));
    CHECK(left.patches.at(0).solution.upper_speed == right.upper_speed);
    CHECK(left.patches[0].solution.upper_temperature == right.upper_temperature);
    CHECK(left.patches[0].solution.lower_temperature == right.lower_temperature);
}

TEST_CASE("Friction by temperature follows each surface's speed, too", "[temperature]") {
    const auto [kind, conformal] = any_slip();
    CAPTURE(kind, conformal);
    WheelRailSetup setup = hot(kind, conformal);
    setup.friction->temperature = TemperatureFriction{-0.2, 0, 900};
    const ContactSolution found = patch_of(setup, sliding(-0.3));
    const WheelRailSetup plane = [&] {
        WheelRailSetup same = setup;
        same.rigid_slip = RigidSlipKind::plane;
        same.conformal = Conformal::off;
        return same;
    }();
    const ContactSolution of_plane = patch_of(plane, sliding(-0.3));
    CHECK_THAT(found.forces.Fx, WithinRel(of_plane.forces.Fx, 2e-3));
    CHECK_THAT(found.temperature->rise, WithinRel(of_plane.temperature->rise, 2e-3));
}

TEST_CASE("A layer that flows on a rail heats wheel and rail by its share of the plastic work", "[temperature]") {
    const auto [kind, conformal] = any_slip();
    CAPTURE(kind, conformal);
    WheelRailSetup setup = hot(kind, conformal);
    setup.dx = setup.dy = 0.4;
    setup.friction->layer = InterfacialLayer{1e-5, 100, 500};
    setup.temperature->plastic_share = GENERATE(1.0, 0.4);
    const ContactSolution found = patch_of(setup, sliding(-0.02));
    CHECK(found.elements.flow > 0);
    const double plastic = found.plastic_power.value();
    CHECK(plastic > 0.1 * found.frictional_power.value());
    CHECK_THAT(found.temperature->heat_upper + found.temperature->heat_lower,
               WithinRel(*found.frictional_power - (1 - setup.temperature->plastic_share) * plastic, 1e-5));
}

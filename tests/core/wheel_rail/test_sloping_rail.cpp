// Tests forces on rails that slope along the track: statics, power, and comparison with other conventions.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double radius = 460, load = 80'000, speed = 20'000;

/// An arc of 300 mm across the track, at a height and rotated by `lean`.
ProfilePoints arc_at(double height, double lean) {
    ProfilePoints arc;
    for (double y = -30; y <= 30; y += 0.5) {
        const double z = 300 - std::sqrt(300 * 300 - y * y);
        arc.points.push_back(
            {std::cos(lean) * y - std::sin(lean) * z, std::sin(lean) * y + std::cos(lean) * z + height});
    }
    return arc;
}

/// Creates a round wheel on a rail that rises by `rise` over each length along the track.
WheelRailSetup uphill(double rise, double lean = 0, double cone = 0) {
    WheelRailSetup setup;
    setup.wheel.shape = ConeProfile{cone, -40, 40};
    setup.wheelset = {1360, -70, radius};
    setup.rail_slices.resize(2);
    setup.rail_slices[0] = {-1000, {ProfileKind::rail, arc_at(1000 * rise, lean)}};
    setup.rail_slices[1] = {1000, {ProfileKind::rail, arc_at(-1000 * rise, lean)}};
    setup.track.rail_origin = ProfilePoint{750, 0};
    setup.friction.reset();
    setup.dx = setup.dy = 0.5;
    return setup;
}

WheelRailState loaded() {
    WheelRailState state;
    state.Fz = load;
    return state;
}

/// Rolls upwards at `speed`, with `creepage` at the rolling radius.
WheelRailState rolling_up(double rise, double creepage) {
    WheelRailState state = loaded();
    state.velocity.x = speed;
    state.velocity.z = -rise * speed;
    state.velocity.pitch = -(1 + creepage) * speed / (radius * std::cos(std::atan(rise)));
    return state;
}

/// Returns the power of the wheelset into the contact (N mm/s).
double power_into_contact(const WheelRailSolution& solution, const WheelRailState& state) {
    const Wrench &track = solution.forces.track, &wheelset = solution.forces.wheelset;
    return track.Fx * state.velocity.x + track.Fz * state.velocity.z + wheelset.My * state.velocity.pitch;
}

}  // namespace

TEST_CASE("A rail that rises is pushed forwards, and the force goes through the axle") {
    const double rise = GENERATE(0.01, -0.03, 0.001);
    WheelRailSetup setup = uphill(rise);
    setup.side = GENERATE(Side::left, Side::right);
    setup.patches.search = GENERATE(ContactSearch::locus, ContactSearch::mesh);
    const WheelRailSolution solution = solve(setup, loaded());
    REQUIRE(solution.in_contact());
    CHECK_THAT(solution.forces.track.Fz, WithinRel(load, 1e-6));
    CHECK_THAT(solution.forces.track.Fx, WithinRel(rise * load, 1e-5));
    // The penetration along the contact plane's direction exceeds that along the surface's normal.
    const double aside = solution.patches[0].place.approach * std::abs(rise);
    CHECK_THAT(solution.forces.wheelset.My, WithinAbs(0, aside * load));
    CHECK_THAT(solution.patches[0].forces.track.Fx, WithinRel(rise * load, 1e-5));
}

// Without friction a straight rail has no force along itself, and a wheel of revolution no moment about its axle.
TEST_CASE("A rail that rises and leans has no force along itself without friction") {
    constexpr double rise = 0.02;
    const auto [lean, cone] = GENERATE(std::pair(0.05, 0.0), std::pair(0.0, -0.05), std::pair(-0.1, -0.1));
    WheelRailSetup setup = uphill(rise, lean, cone);
    setup.side = GENERATE(Side::left, Side::right);
    setup.conformal = GENERATE(Conformal::off, Conformal::half_space);
    const WheelRailSolution solution = solve(setup, loaded());
    REQUIRE(solution.in_contact());
    CHECK_THAT(solution.forces.track.Fx, WithinRel(rise * load, 2e-4));
    CHECK_THAT(solution.forces.wheelset.My, WithinAbs(0, 2e-3 * rise * load * radius));
}

TEST_CASE("Simplified models bear the slope of the rail, too") {
    WheelRailSetup setup = uphill(0.01);
    setup.model = GENERATE(Model::hertz, Model::fastsim);
    setup.side = GENERATE(Side::left, Side::right);
    const WheelRailSolution solution = solve(setup, loaded());
    CHECK_THAT(solution.forces.track.Fx, WithinRel(0.01 * load, 1e-6));
    CHECK_THAT(solution.forces.wheelset.My, WithinAbs(0, 1e-3 * 0.01 * load * radius));
}

TEST_CASE("A rail on springs bears the slope of what it carries") {
    WheelRailSetup setup = uphill(0.01);
    setup.track.springs = RailSprings{20'000, 80'000};
    const WheelRailSolution solution = solve(setup, loaded());
    REQUIRE(solution.rail_deflection);
    CHECK_THAT(solution.rail_deflection->z, WithinRel(1.0, 1e-5));
    CHECK_THAT(solution.forces.track.Fx, WithinRel(0.01 * load, 1e-5));
}

// The normal of both surfaces intersects both axles.
TEST_CASE("A wheel ahead of a roller's top pushes it along the line between both axles") {
    constexpr double ahead = 20, of_roller = 600;
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.track.roller_radius = of_roller;
    setup.patches.search = ContactSearch::mesh;
    setup.dx = setup.dy = 0.5;
    setup.side = GENERATE(Side::left, Side::right);
    WheelRailState state = loaded();
    state.wheel.x = ahead;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.in_contact());
    const double between = std::sqrt(std::pow(450 + of_roller, 2) - ahead * ahead);
    CHECK_THAT(solution.forces.track.Fx, WithinRel(-load * ahead / between, 1e-3));
    const double about_wheel = solution.forces.wheelset.My + ahead * solution.forces.wheelset.Fz;
    CHECK_THAT(about_wheel, WithinAbs(0, 2e-3 * ahead * load));
}

TEST_CASE("What a wheel that rolls uphill puts into the contact is what friction dissipates") {
    const double rise = GENERATE(0.0, 0.01, -0.03), creepage = GENERATE(1e-4, 2e-3, -0.01);
    WheelRailSetup setup = uphill(rise);
    setup.friction = WheelRailFriction{};
    setup.side = GENERATE(Side::left, Side::right);
    setup.slope_forces = GENERATE(SlopeForces::pressure, SlopeForces::all);
    const WheelRailState state = rolling_up(rise, creepage);
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.frictional_power());
    const WheelRailPatch& patch = solution.patches.at(0);
    // Creepages refer to the wheel's surface, deeper by the approach than the point of the forces, and level.
    const double convention = 2.5 * patch.place.approach / radius + rise * rise;
    CHECK_THAT(power_into_contact(solution, state),
               WithinAbs(*solution.frictional_power(), convention * std::abs(patch.solution.forces.Fx) * speed));
}

TEST_CASE("A wheel that is hauled uphill without a moment has no friction") {
    constexpr double rise = 0.01;
    WheelRailSetup setup = uphill(rise);
    setup.friction = WheelRailFriction{};
    WheelRailState state = rolling_up(rise, 0);
    state.Fx = rise * load;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.pitch_search);
    CHECK(solution.pitch_search->converged);
    CHECK_THAT(solution.patches[0].solution.forces.Fx, WithinAbs(0, 1e-4 * load));
    CHECK_THAT(solution.pitch_rate, WithinRel(state.velocity.pitch, 1e-5));
}

TEST_CASE("All forces of a contact turn with a rail that rises, its pressures, or none") {
    constexpr double rise = 0.02;
    const SlopeForces which = GENERATE(SlopeForces::pressure, SlopeForces::all, SlopeForces::none);
    WheelRailSetup setup = uphill(rise);
    setup.friction = WheelRailFriction{};
    setup.slope_forces = which;
    const WheelRailSolution solution = solve(setup, rolling_up(rise, 3e-3));
    const Forces& forces = solution.patches.at(0).solution.forces;
    REQUIRE(std::abs(forces.Fx) > 0.1 * load);
    const double pushed = which == SlopeForces::none ? 0 : rise * forces.Fn;
    const double lifted = which == SlopeForces::all ? rise * forces.Fx : 0;
    CHECK_THAT(solution.forces.track.Fx, WithinAbs(forces.Fx + pushed, 1e-5 * load));
    CHECK_THAT(solution.forces.track.Fz, WithinAbs(forces.Fn - lifted, 1e-5 * load));
}

TEST_CASE("Derivatives of forces on a rail that rises have its slope") {
    constexpr double rise = 0.02;
    WheelRailSetup setup = uphill(rise);
    setup.side = GENERATE(Side::left, Side::right);
    WheelRailState state = loaded();
    state.derivatives = true;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.derivatives);
    const Wrench& by_z = solution.derivatives->position.z;
    CHECK(by_z.Fz > 1e5);
    CHECK_THAT(by_z.Fx, WithinRel(rise * by_z.Fz, 1e-3));
}

// A wheel whose centre lies ahead of its axle touches there, and level rails have no force along themselves.
TEST_CASE("An eccentric wheel on a level rail has the moment of its vertical force") {
    constexpr double ahead = 5;
    WheelRailSetup setup = cylinder_on_arc(300);
    for (int i = -40; i <= 40; ++i) {
        const double angle = i * 3.0 / 40;
        ProfilePoints points;
        for (double y = -40; y <= 40; y += 1) points.points.push_back({y, ahead * std::sin(angle)});
        setup.wheel_slices.push_back({angle, {ProfileKind::wheel, points}});
    }
    setup.dx = setup.dy = 0.5;
    const WheelRailSolution solution = solve(setup, loaded());
    REQUIRE(solution.in_contact());
    CHECK(solution.forces.track.Fx == 0);
    CHECK_THAT(solution.forces.wheelset.My, WithinRel(-ahead * load, 0.02));
}

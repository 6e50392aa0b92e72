#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>

#include "closed_forms/hertz.hpp"
#include "contactd/error.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "wheel_rail/manchester.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/random_wheel_rail.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

WheelRailSolution solve(const WheelRailSetup& setup, const WheelRailState& state) {
    Observer observer;
    return solve_wheel_rail(setup, state, observer);
}

/// A cylindrical wheel of 450 mm on a rail with one radius, elements fine enough for a percent.
WheelRailSetup cylinder_on_arc(double radius) {
    WheelRailSetup setup;
    setup.wheel.shape = ConeProfile{0, -40, 40};
    setup.rail.shape = ArcProfile{radius, 0, -30, 30};
    setup.track.rail_origin = ProfilePoint{750, 0};
    setup.wheelset = {1360, -70, 450};
    setup.friction.reset();
    return setup;
}

void same(const Wrench& a, const Wrench& b) {
    CHECK(a == b);
}

}  // namespace

TEST_CASE("A left wheel is a right one in a mirror, to the last bit") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.friction = WheelRailFriction{{{-0.5, 0.2}, {0.1, 0.4}}, true, {}};
    WheelRailState state;
    state.position = {6, 0, 0.002, 0.012};
    state.rail = {0.3, 0.1, 0.004};
    state.velocity = {20000, 15, 3, 0.01, 0.02, -43};
    state.Fz = 60000;
    const WheelRailSolution right = solve(setup, state);
    setup.side = Side::left;
    const WheelRailSolution left = mirrored(solve(setup, mirrored(state)));
    CHECK(left.z == right.z);
    same(left.forces.track, right.forces.track);
    same(left.forces.rail, right.forces.rail);
    same(left.forces.wheelset, right.forces.wheelset);
    REQUIRE(left.patches.size() == right.patches.size());
    REQUIRE_FALSE(right.patches.empty());
    for (std::size_t i = 0; i < left.patches.size(); ++i) {
        CHECK(left.patches[i].place.reference == right.patches[i].place.reference);
        CHECK(left.patches[i].solution.pressure == right.patches[i].solution.pressure);
        CHECK(left.patches[i].solution.traction_y == right.patches[i].solution.traction_y);
        CHECK(left.patches[i].gap == right.patches[i].gap);
    }
}

TEST_CASE("The height that a force brings brings that force") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.model = GENERATE(Model::full, Model::fastsim);
    WheelRailState state;
    state.position.y = GENERATE(0.0, 5.3, 7.5);
    state.position.yaw = 0.01;
    state.velocity = {20000, 0, 0, 0, 0, -43.5};
    state.Fz = 80000;
    const WheelRailSolution by_force = solve(setup, state);
    REQUIRE(by_force.converged());
    CHECK_THAT(by_force.forces.track.Fz, WithinRel(80000, 1e-6));
    state.Fz.reset();
    state.position.z = by_force.z;
    const WheelRailSolution by_height = solve(setup, state);
    same(by_height.forces.track, by_force.forces.track);
    CHECK(by_height.z == by_force.z);
}

TEST_CASE("A wheel that is lifted has no contact, and says how far it is away") {
    WheelRailState state;
    const WheelRailContact contact(WheelRailSetup{});
    const std::optional<double> touch = contact.touch(state);
    REQUIRE(touch);
    state.position.z = *touch - 0.5;
    Observer observer;
    const WheelRailSolution solution = contact.solve(state, observer);
    CHECK_FALSE(solution.in_contact());
    CHECK(solution.forces.track == Wrench{});
    CHECK_THAT(solution.clearance.value(), WithinAbs(0.5, 1e-12));
}

TEST_CASE("A wheel beside its rail has no contact at any height") {
    WheelRailState state;
    state.position.y = 200;
    state.Fz = GENERATE(std::optional<double>{}, std::optional(1e4));
    const WheelRailSolution solution = solve({}, state);
    CHECK_FALSE(solution.in_contact());
    CHECK_FALSE(solution.clearance);
    REQUIRE(solution.warnings.size() == 1);
    CHECK_THAT(solution.warnings[0], ContainsSubstring("above the rail"));
}

TEST_CASE("A cylinder on an arc is Hertz's contact") {
    const double radius = GENERATE(100.0, 300.0), Fn = 60000;
    WheelRailSetup setup = cylinder_on_arc(radius);
    setup.model = GENERATE(Model::full, Model::hertz);
    setup.dx = setup.dy = 0.25;
    WheelRailState state;
    state.Fz = Fn;
    double along = 450;
    SECTION("on a rail") {}
    SECTION("on a roller") {
        setup.track.roller_radius = 600;
        along = 1 / (1 / 450.0 + 1 / 600.0);
    }
    const WheelRailSolution solution = solve(setup, state);
    const HertzContact known = hertz_of_force({along, radius}, setup.bodies.materials().normal_compliance(), Fn);
    REQUIRE(solution.converged());
    REQUIRE(solution.patches.size() == 1);
    const WheelRailPatch& patch = solution.patches[0];
    CHECK_THAT(patch.place.reference.y, WithinAbs(750, 1e-6));
    CHECK_THAT(patch.place.reference.angle, WithinAbs(0, 1e-8));
    CHECK_THAT(patch.solution.pmax, WithinRel(known.pmax, 5e-3));
    CHECK_THAT(patch.solution.approach, WithinRel(known.approach, 5e-3));
    CHECK_THAT(patch.place.radii.wheel_along, WithinRel(450, 1e-6));
    CHECK_THAT(patch.place.radii.rail_across, WithinRel(radius, 1e-4));
    CHECK_THAT(solution.z, WithinRel(known.approach, 5e-3));
}

TEST_CASE("A cone that rolls has the creepages and the spin of its angle") {
    const double slope = 0.05, r = 450, v = 10000;
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.wheel.shape = ConeProfile{-slope, -40, 40};
    setup.friction = WheelRailFriction{};
    WheelRailState state;
    state.velocity = {v, 0, 0, 0, 0, -v / r};
    state.Fz = 10000;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.patches.size() == 1);
    const ContactPlace& place = solution.patches[0].place;
    // The rail touches where it has the cone's slope, a rail's 1/R from its top.
    const double y = -300 * std::sin(std::atan(slope));
    CHECK_THAT(place.reference.y, WithinAbs(750 + y, 2e-3));
    CHECK_THAT(std::tan(place.reference.angle), WithinAbs(-slope, 1e-5));
    CHECK_THAT(place.creepages.phi, WithinRel(std::sin(std::atan(slope)) / r, 1e-3));
    CHECK_THAT(place.creepages.xi, WithinAbs(-slope * y / r, 2e-6));
    CHECK_THAT(place.creepages.eta, WithinAbs(0, 1e-12));
    CHECK(place.creepages.chi == 0);
}

TEST_CASE("A wheelset that is yawed creeps sideways by its yaw") {
    WheelRailSetup setup = cylinder_on_arc(300);
    WheelRailState state;
    state.position.yaw = 0.004;
    state.velocity = {10000, 0, 0, 0, 0, -10000 / 450.0};
    state.Fz = 10000;
    // The rail slips over the wheel, whose rim points to the right: (cos, sin) of the yaw.
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.patches.size() == 1);
    CHECK_THAT(solution.patches[0].place.creepages.eta, WithinRel(std::sin(0.004), 1e-3));
    CHECK_THAT(solution.patches[0].place.creepages.velocity, WithinRel(10000, 1e-3));
}

TEST_CASE("Forces have the same moment in all coordinates") {
    WheelRailState state;
    state.position = {7.2, 0, 0.001, 0.015};
    state.velocity = {20000, 0, 0, 0, 0, -43};
    state.Fz = 50000;
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    const WheelRailSolution solution = solve(setup, state);
    const Wrench &track = solution.forces.track, &wheelset = solution.forces.wheelset;
    // About the axle's centre (0, y, z - r), by hand; the axes roll and yaw, which leaves the length.
    const double y = state.position.y, z = solution.z - 460;
    const double Mx = track.Mx - (y * track.Fz - z * track.Fy), My = track.My - z * track.Fx,
                 Mz = track.Mz + y * track.Fx;
    CHECK_THAT(std::hypot(wheelset.Mx, wheelset.My, wheelset.Mz), WithinRel(std::hypot(Mx, My, Mz), 1e-10));
    CHECK_THAT(wheelset.Fx * wheelset.Mx + wheelset.Fy * wheelset.My + wheelset.Fz * wheelset.Mz,
               WithinRel(track.Fx * Mx + track.Fy * My + track.Fz * Mz, 1e-9));
}

TEST_CASE("Friction that differs by the contact angle is that of the tread or of the flange") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.friction = WheelRailFriction{{{-0.6, 0.1}, {-0.3, 0.4}}, GENERATE(true, false), {}};
    WheelRailState state;
    state.velocity = {20000, 0, 0, 0, 0, -43};
    state.Fz = 50000;
    const auto [y, mu] = GENERATE(std::pair(0.0, 0.4), std::pair(8.5, 0.1));
    state.position.y = y;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE_FALSE(solution.patches.empty());
    const ContactSolution& innermost = solution.patches.back().solution;
    double used = 0;
    for (std::size_t i = 0; i < innermost.pressure.size(); ++i)
        if (innermost.element_division[i] == ElementState::slip)
            used = std::max(used, std::hypot(innermost.traction_x[i], innermost.traction_y[i]) / innermost.pressure[i]);
    CHECK_THAT(used, WithinRel(mu, 1e-6));
}

TEST_CASE("Mistakes in a set-up are refused by name") {
    const auto refused = [](const std::function<void(WheelRailSetup&)>& spoil, const std::string& sentence) {
        WheelRailSetup setup;
        spoil(setup);
        REQUIRE_THROWS_AS(WheelRailContact(setup), InvalidArgument);
        CHECK_THROWS_WITH(WheelRailContact(setup), ContainsSubstring(sentence));
    };
    refused([](auto& setup) { setup.track.gauge = -1435; }, "track.gauge is -1435");
    refused([](auto& setup) { setup.track.gauge = 40; }, "track.gauge is 40");
    refused([](auto& setup) { setup.track.gauge_height = -1; }, "track.gauge_height is -1");
    refused([](auto& setup) { setup.track.cant = 1.4; }, "track.cant is 1.4");
    refused([](auto& setup) { setup.wheelset.nominal_radius = 0; }, "wheelset.nominal_radius is 0");
    refused([](auto& setup) { setup.wheelset.nominal_radius = 2; }, "wheelset.nominal_radius is 2");
    refused([](auto& setup) { setup.wheelset.flange_back_position = 900; }, "wheelset.flange_back_position is 900");
    refused([](auto& setup) { setup.dx = NAN; }, "dx is nan");
    refused([](auto& setup) { setup.dy = 0; }, "dy is 0");
    refused([](auto& setup) { setup.patches.distance_combine = 9; }, "patches.distance_separate is 8");
    refused([](auto& setup) { setup.friction->mu = {}; }, "friction.mu is empty");
    refused([](auto& setup) { setup.friction->mu = {{0, -0.3}}; }, "friction.mu[0].mu is -0.3");
    refused([](auto& setup) { setup.friction->mu = {{0, 0.3}, {-1, 0.3}}; }, "friction.mu[1].angle is -1");
    refused([](auto& setup) { std::swap(setup.wheel, setup.rail); }, "wheel.kind is rail");
    refused([](auto& setup) { setup.rail.shape = ProfilePoints{{{0, 0}}}; }, "rail.points");
    refused([](auto& setup) { setup.bodies.upper.material.G = -1; }, "bodies.upper.G is -1");
}

TEST_CASE("Mistakes in a state are refused by name") {
    const WheelRailContact contact(WheelRailSetup{});
    const auto refused = [&](const WheelRailState& state, const std::string& sentence) {
        Observer observer;
        CHECK_THROWS_AS(contact.solve(state, observer), InvalidArgument);
        CHECK_THROWS_WITH(contact.solve(state, observer), ContainsSubstring(sentence));
    };
    WheelRailState state;
    SECTION("a wheel far inside its rail") {
        state.position.z = 10;
        refused(state, "position.z is 10; there the wheel is 9.");
    }
    SECTION("degrees") {
        state.position.yaw = 2;
        refused(state, "position.yaw is 2");
    }
    SECTION("a force that pulls") {
        state.Fz = -1e4;
        refused(state, "Fz is -10000");
    }
    SECTION("no number") {
        state.velocity.pitch = NAN;
        refused(state, "velocity.pitch is nan");
    }
}

TEST_CASE("A wheelset that stands still is solved without friction, and says so") {
    WheelRailState state;
    state.Fz = 1e4;
    const WheelRailSolution solution = solve({}, state);
    CHECK(solution.converged());
    REQUIRE(solution.warnings.size() == 1);
    CHECK_THAT(solution.warnings[0], ContainsSubstring("does not roll"));
}

TEST_CASE("Random positions have an answer, and their forces balance") {
    Observer observer;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Dice dice(seed);
        RandomWheelRail problem{random_setup(dice, 1), {}};
        const WheelRailContact contact(problem.setup);
        for (int i = 0; i < 3; ++i) {
            problem.state = random_state(dice, contact);
            INFO("seed " << seed << ", state " << i);
            CHECK(wheel_rail_faults(problem, contact.solve(problem.state, observer)).empty());
        }
    }
}

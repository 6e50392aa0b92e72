// What a user gets wrong.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>

#include "contactd/error.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;

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

// Tests wheels on rails at the limits of valid input.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "wheel_rail/borderline_wheel_rail.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

TEST_CASE("Borderline wheels are answered, or refused by the name of what was given") {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        INFO("seed " << seed);
        CHECK(borderline_fault(seed) == "");
    }
}

TEST_CASE("A candidate patch without wheel or rail along the normal is left out with a warning") {
    WheelRailSetup setup;
    setup.rail.shape = ProfilePoints{{{-6.09, -.63}, {-5.72, -.5}, {-2.34, -.08}, {-1.59, -.06}, {-1.21, -.06}}};
    setup.dx = setup.dy = 0.4;
    WheelRailState state;
    state.position.y = 6;
    state.position.z = -12;
    const WheelRailSolution solution = solve(setup, state);
    CHECK(solution.patches.empty());
    REQUIRE_FALSE(solution.warnings.empty());
    CHECK_THAT(solution.warnings.back(), ContainsSubstring("is neglected"));
}

TEST_CASE("A spin that moves nothing leaves Hertz's closed form its friction") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.model = Model::hertz;
    setup.friction = WheelRailFriction{};
    WheelRailState state;
    state.Fz = 60000;
    state.velocity = {20000, 10, 0, 0, 0, -20000.0 / 450};
    const WheelRailSolution still = solve(setup, state);
    REQUIRE(still.converged());
    state.velocity.yaw = 1e-100;
    CHECK(solve(setup, state).forces.track == still.forces.track);
    state.velocity.yaw = 0.1;
    CHECK_THROWS_WITH(solve(setup, state),
                      StartsWith("model is hertz, whose closed form of friction does not support spin"));
}

TEST_CASE("Forces and steps that are next to nothing are refused by name") {
    WheelRailSetup setup;
    WheelRailState state;
    state.velocity = {20000, 0, 0, 0, 0, -43};
    for (const double force : {5e-324, 1e-100, 9e-7}) {
        state.Fz = force;
        CHECK_THROWS_WITH(solve(setup, state), StartsWith("state.Fz is ") && ContainsSubstring("at least 1e-06 N"));
    }
    state.Fz = 1e-6;
    CHECK_NOTHROW(solve(setup, state));
    setup.dq = 5e-324;
    state.Fz = 60000;
    CHECK_THROWS_WITH(solve(setup, state), StartsWith("dq as the step of rolling is"));
}

TEST_CASE("Springs that are next to nothing are refused by name") {
    WheelRailSetup setup;
    setup.track.springs = RailSprings{{}, 5e-324};
    CHECK_THROWS_WITH(WheelRailContact(setup),
                      StartsWith("track.springs.z is ") && ContainsSubstring("at least 0.001 N/mm"));
}

TEST_CASE("A friction that is next to nothing is none to the simplified models") {
    WheelRailSetup setup;
    setup.model = Model::fastsim;
    setup.friction = WheelRailFriction{{{0, 5e-324}}, false, {}};
    WheelRailState state;
    state.velocity = {20000, 100, 0, 0, 0, -43};
    state.Fz = 60000;
    const WheelRailSolution solution = solve(setup, state);
    CHECK(solution.converged());
    CHECK(is_finite(solution));
}

TEST_CASE("A curved contact under next to no rolling has no friction") {
    WheelRailSetup setup;
    setup.conformal = Conformal::rotated;
    setup.dx = setup.dy = 0.5;
    WheelRailState state;
    state.velocity = {5e-324, 14, 0, 0, 0, 158};
    state.Fz = 6000;
    const WheelRailSolution solution = solve(setup, state);
    CHECK(is_finite(solution));
    CHECK_THAT(solution.warnings.front(), ContainsSubstring("does not roll"));
}

TEST_CASE("A wheel that slides with next to no rolling is refused as not rolling") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    WheelRailState state;
    state.Fz = 60000;
    state.velocity.x = 1e-300;
    state.velocity.y = 100;
    const WheelRailSolution solution = solve(setup, state);
    CHECK(solution.converged());
    REQUIRE_FALSE(solution.warnings.empty());
    CHECK_THAT(solution.warnings.front(), ContainsSubstring("does not roll"));
}

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "wheel_rail/mirror.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

WheelRailState rolling_state() {
    WheelRailState state;
    state.position = {2, 0, 0.0005, 0.001};
    state.velocity = {20000, 10, 0, 0, 0.01, -43.4};
    state.Fz = 80000;
    state.derivatives = true;
    return state;
}

WheelRailSetup half_millimetres(Model model = Model::full) {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.model = model;
    return setup;
}

/// Uses steps so wide that a solver's tolerance does not matter.
template <class Struct, class Number>
Wrench long_difference(const WheelRailSetup& setup, WheelRailState state, Struct WheelRailState::* part,
                       Number Struct::* input, double step) {
    state.derivatives = false;
    const auto move = [&](double by) { (state.*part).*input = std::optional((state.*part).*input).value() + by; };
    move(step);
    const Wrench more = solve(setup, state).forces.track;
    move(-2 * step);
    const Wrench less = solve(setup, state).forces.track;
    return {(more.Fx - less.Fx) / (2 * step), (more.Fy - less.Fy) / (2 * step), (more.Fz - less.Fz) / (2 * step)};
}

void near(const Wrench& derivative, const Wrench& known, double share) {
    const double size = share * std::hypot(known.Fx, known.Fy, known.Fz);
    CHECK_THAT(derivative.Fx, WithinAbs(known.Fx, size));
    CHECK_THAT(derivative.Fy, WithinAbs(known.Fy, size));
    CHECK_THAT(derivative.Fz, WithinAbs(known.Fz, size));
}

}  // namespace

TEST_CASE("Forces follow position and motion as their derivatives say") {
    const WheelRailSetup setup = half_millimetres(GENERATE(Model::full, Model::fastsim));
    WheelRailState state = rolling_state();
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.derivatives);
    state.position.z = solution.z;
    state.Fz.reset();
    const auto& [position, velocity] = *solution.derivatives;
    const auto by_position = [&](auto WheelsetPosition::* input, double step) {
        return long_difference(setup, state, &WheelRailState::position, input, step);
    };
    const auto by_velocity = [&](double WheelsetVelocity::* input, double step) {
        return long_difference(setup, state, &WheelRailState::velocity, input, step);
    };
    // Elements come into contact and leave it on the way, but their derivatives are those of one division.
    near(position.y, by_position(&WheelsetPosition::y, 0.02), 0.03);
    near(position.z, by_position(&WheelsetPosition::z, 5e-4), 0.03);
    near(position.roll, by_position(&WheelsetPosition::roll, 5e-7), 0.03);
    near(position.yaw, by_position(&WheelsetPosition::yaw, 3e-5), 0.03);
    near(velocity.x, by_velocity(&WheelsetVelocity::x, 0.5), 0.02);
    near(velocity.y, by_velocity(&WheelsetVelocity::y, 0.5), 0.02);
    near(velocity.z, by_velocity(&WheelsetVelocity::z, 1), 0.02);
    near(velocity.roll, by_velocity(&WheelsetVelocity::roll, 1e-3), 0.02);
    near(velocity.yaw, by_velocity(&WheelsetVelocity::yaw, 1e-3), 0.02);
    near(velocity.pitch, by_velocity(&WheelsetVelocity::pitch, 1e-3), 0.02);
}

TEST_CASE("A wheel that goes down presses as Hertz's theory says") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 0.25;
    WheelRailState state;
    state.Fz = 60000;
    state.derivatives = true;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.derivatives);
    // Fz is proportional to z to the power of 1.5.
    CHECK_THAT(solution.derivatives->position.z.Fz, WithinRel(1.5 * 60000 / solution.z, 0.01));
    CHECK_THAT(solution.derivatives->position.roll.Fz, WithinRel(750 * 1.5 * 60000 / solution.z, 0.01));
    CHECK(solution.derivatives->velocity.x == Wrench{});
}

TEST_CASE("Derivatives of a left wheel are those in the mirror") {
    WheelRailSetup setup = half_millimetres();
    const WheelRailState state = rolling_state();
    const WheelRailSolution right = solve(setup, state);
    setup.side = Side::left;
    const WheelRailSolution left = mirrored(solve(setup, mirrored(state)));
    REQUIRE(left.derivatives);
    CHECK(left.derivatives->position.y == right.derivatives->position.y);
    CHECK(left.derivatives->position.z == right.derivatives->position.z);
    CHECK(left.derivatives->velocity.yaw == right.derivatives->velocity.yaw);
    CHECK(left.derivatives->velocity.pitch == right.derivatives->velocity.pitch);
}

TEST_CASE("Without contact there are no derivatives, and a word about it") {
    WheelRailState state = rolling_state();
    state.Fz.reset();
    state.position.z = -20;
    const WheelRailSolution solution = solve({}, state);
    CHECK_FALSE(solution.derivatives);
    REQUIRE(solution.warnings.size() == 1);
    CHECK_THAT(solution.warnings[0], ContainsSubstring("no derivatives"));
}

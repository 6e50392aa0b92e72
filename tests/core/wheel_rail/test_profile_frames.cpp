// Tests the axes of both profiles in an answer.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "geometry/placement/vector3.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using geometry::Rotation;
using geometry::Vector3;

namespace {

WheelRailState rolling_state(Side side) {
    WheelRailState state;
    state.position = {side == Side::right ? 2.0 : -2.0, std::nullopt, 0.003, 0.01};
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 80000;
    return state;
}

void check_same(const Vector3& a, const Vector3& b, double tolerance) {
    CHECK_THAT(a.x, WithinAbs(b.x, tolerance));
    CHECK_THAT(a.y, WithinAbs(b.y, tolerance));
    CHECK_THAT(a.z, WithinAbs(b.z, tolerance));
}

/// Checks that the forces on the rail in its own axes are those of the track about the origin of the frame.
void check_rail_frame(const WheelRailSolution& solution) {
    const auto& [x, y, z, roll, yaw] = solution.rail_frame;
    const Wrench &track = solution.forces.track, &rail = solution.forces.rail;
    const Rotation axes = Rotation::yaw_then_roll(yaw, roll);
    const Vector3 force{track.Fx, track.Fy, track.Fz}, moment{track.Mx, track.My, track.Mz};
    check_same(axes.rotated_back(force), {rail.Fx, rail.Fy, rail.Fz}, 1e-9 * track.Fz);
    check_same(axes.rotated_back(moment - cross({x, y, z}, force)), {rail.Mx, rail.My, rail.Mz}, 1e-9 * 750 * track.Fz);
}

}  // namespace

TEST_CASE("Moments of a rail are about the origin of its frame") {
    const Side side = GENERATE(Side::left, Side::right);
    WheelRailSetup setup;
    setup.side = side;
    setup.dx = setup.dy = 1;
    WheelRailState state = rolling_state(side);
    SECTION("in its place") {}
    SECTION("with a deviation") {
        state.rail.y = 0.7;
        state.rail.z = -0.4;
        state.rail.roll = 0.01;
    }
    SECTION("of a roller") {
        setup.track.roller_radius = 500;
    }
    SECTION("in slices") {
        setup.rail_slices = {{-500, setup.rail}, {0, setup.rail}, {500, setup.rail}};
        setup.track.rail_origin = ProfilePoint{750, 0};
        state.position.x = 100;
    }
    SECTION("on springs") {
        setup.track.springs = {1e4, 1e5};
        const WheelRailSolution solution = solve(setup, state);
        setup.track.springs.reset();
        const WheelRailSolution fixed = solve(setup, state);
        const auto& deflection = solution.rail_deflection.value();
        CHECK_THAT(solution.rail_frame.y - fixed.rail_frame.y, WithinAbs(deflection.y, 1e-9));
        CHECK_THAT(solution.rail_frame.z - fixed.rail_frame.z, WithinAbs(deflection.z, 1e-9));
        check_rail_frame(solution);
    }
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.in_contact());
    check_rail_frame(solution);
    const double inwards = side == Side::right ? -setup.track.cant : setup.track.cant;
    CHECK_THAT(solution.rail_frame.roll, WithinAbs(inwards + state.rail.roll, 1e-15));
    CHECK(solution.rail_frame.yaw == 0);
}

TEST_CASE("The frame of a wheel is that of its wheelset and its deviation") {
    const Side side = GENERATE(Side::left, Side::right);
    WheelRailSetup setup;
    setup.side = side;
    setup.dx = setup.dy = 1;
    const Wheelset& wheelset = setup.wheelset;
    WheelRailState state = rolling_state(side);
    state.wheel.x = 0.3;
    state.wheel.y = 0.2;
    state.wheel.z = 0.1;
    const WheelRailSolution solution = solve(setup, state);
    const auto& [x, y, z, roll, yaw] = solution.wheel_frame;
    const double along = wheelset.flange_back_distance / 2 - wheelset.flange_back_position;
    const Vector3 centre{0, state.position.y, solution.z - wheelset.nominal_radius};
    const Rotation axes = Rotation::yaw_then_roll(state.position.yaw, state.position.roll);
    const Vector3 in_wheelset{0.3, (side == Side::right ? along : -along) + 0.2, wheelset.nominal_radius + 0.1};
    check_same({x, y, z}, centre + axes * in_wheelset, 1e-9);
    CHECK_THAT(roll, WithinAbs(state.position.roll, 1e-15));
    CHECK_THAT(yaw, WithinAbs(state.position.yaw, 1e-15));
}

TEST_CASE("The frame of a wheel turns with its deviation") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 1;
    WheelRailState state = rolling_state(Side::right);
    state.wheel.roll = 0.004;
    state.wheel.yaw = -0.003;
    const WheelRailSolution rotated = solve(setup, state);
    const double products = 1e-4;  // of two angles
    CHECK_THAT(rotated.wheel_frame.roll, WithinAbs(state.position.roll + 0.004, products));
    CHECK_THAT(rotated.wheel_frame.yaw, WithinAbs(state.position.yaw - 0.003, products));
    state.wheel = {};
    state.position.z = rotated.z;
    state.Fz.reset();
    const WheelRailSolution rigid = solve(setup, state);
    check_same({rotated.wheel_frame.x, rotated.wheel_frame.y, rotated.wheel_frame.z},
               {rigid.wheel_frame.x, rigid.wheel_frame.y, rigid.wheel_frame.z}, 1e-9);
}

TEST_CASE("A wheel beside its rail has frames, too") {
    WheelRailSetup setup;
    WheelRailState state = rolling_state(Side::right);
    state.position.y = 300;
    state.position.z = 0;
    state.Fz.reset();
    Observer observer;
    const WheelRailContact contact(setup);
    const WheelRailSolution solution = contact.solve(state, observer);
    CHECK_FALSE(solution.in_contact());
    CHECK(solution.wheel_frame == contact.locate(state, observer).wheel_frame);
    CHECK(solution.rail_frame == contact.locate(state, observer).rail_frame);
    state.position.y = 2;
    CHECK(solution.wheel_frame.y - contact.locate(state, observer).wheel_frame.y == 298);
}

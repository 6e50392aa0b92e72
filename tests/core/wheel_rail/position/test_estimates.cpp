// Tests estimates that a step of a wheel on its rail leaves for the next one.
#include "wheel_rail/position/estimates.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contactd/solve_wheel_rail.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

using Patch = WheelRailEstimates::Patch;

/// Creates pressures that identify their positions.
Patch patch_on(const Grid& grid, double y) {
    Patch patch{grid, y, {}, 0, {}};
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) patch.tractions.pressure.push_back(100 * grid.x(ix) + grid.y(iy));
    return patch;
}

ContactPlace place_on(const Grid& grid, double y) {
    ContactPlace place;
    place.grid = grid;
    place.reference.y = y;
    return place;
}

WheelRailSetup coarse_setup(Side side) {
    WheelRailSetup setup;
    setup.side = side;
    setup.dx = setup.dy = 1;
    return setup;
}

WheelRailState state_at(double y) {
    WheelRailState state;
    state.position.y = y;
    state.position.yaw = 1e-3;
    state.velocity.x = 2000;
    state.velocity.pitch = -2000 / 460.0;
    state.Fz = 1e4;
    return state;
}

}  // namespace

TEST_CASE("Tractions move with the reference of their patch, by whole elements") {
    const Patch before = patch_on({4, 3, 0.5, 0.25, -1, -0.375}, 750);
    CHECK(estimate_for(place_on(before.grid, 750.1), {before}).pressure == before.tractions.pressure);

    const Grid larger{6, 3, 0.5, 0.25, -1.5, -0.125};
    const SurfaceState moved = estimate_for(place_on(larger, 750.1), {before});
    REQUIRE(moved.pressure.size() == larger.size());
    CHECK(moved.pressure[0] == 0);
    CHECK(moved.pressure[1] == before.tractions.pressure[4]);
    CHECK(moved.pressure[2 * 6 + 1] == 0);
    CHECK(moved.traction_x.empty());
}

TEST_CASE("A patch starts from the one that was nearest, of equal elements") {
    const Grid grid{2, 20, 0.5, 0.25, -0.5, -2.5};
    const Patch tread = patch_on(grid, 750);
    Patch flange = patch_on(grid, 720);
    flange.tractions.pressure.assign(grid.size(), 7);
    CHECK(estimate_for(place_on(grid, 721), {tread, flange}).pressure == flange.tractions.pressure);
    CHECK(estimate_for(place_on(grid, 740), {tread, flange}).empty());
    Grid finer = grid;
    finer.dx = 0.4;
    CHECK(estimate_for(place_on(finer, 750), {tread}).empty());
    CHECK(estimate_for(place_on(grid, 750), {}).empty());
}

TEST_CASE("Estimates change what a step costs and not what it answers") {
    const Side side = GENERATE(Side::left, Side::right);
    const WheelRailContact contact(coarse_setup(side));
    Observer observer;
    WheelRailEstimates estimates;
    const WheelRailSolution first = contact.solve(state_at(1), estimates, observer);
    CHECK_THAT(first.forces.track.Fy, WithinAbs(contact.solve(state_at(1), observer).forces.track.Fy, 0.05));
    CHECK(estimates.patches.size() == first.patches.size());
    CHECK(estimates.height.logarithm != 0);
    int with = 0, without = 0;
    for (const double y : {1.02, 1.04, 1.06, 1.08, 6.5}) {
        const WheelRailSolution one = contact.solve(state_at(y), estimates, observer);
        const WheelRailSolution other = contact.solve(state_at(y), observer);
        CHECK_THAT(one.forces.track.Fx, WithinAbs(other.forces.track.Fx, 0.05));
        CHECK_THAT(one.forces.track.Fy, WithinAbs(other.forces.track.Fy, 0.05));
        CHECK_THAT(one.forces.track.Fz, WithinAbs(1e4, 0.0101));
        with += one.force->iterations;
        without += other.force->iterations;
    }
    CHECK(with < without);
}

TEST_CASE("What a step has is expected to change as it did before, until it jumps") {
    Trend trend;
    CHECK_FALSE(trend.expected());
    for (const double value : {1.0, 1.01, 1.04}) {
        trend.learn(value);
        CHECK(trend.expected() == value);
        trend.end_step();
    }
    CHECK_THAT(trend.expected().value(), WithinAbs(1.09, 1e-12));  // 1 + k^2/100
    trend.learn(2.0);
    trend.end_step();
    CHECK(trend.expected() == 2.0);
    trend.learn(std::nullopt);
    trend.end_step();
    CHECK_FALSE(trend.expected());
}

TEST_CASE("A wheel that hunts under its load takes about two solves a step") {
    const WheelRailContact contact(coarse_setup(Side::right));
    Observer observer;
    WheelRailEstimates estimates;
    int solves = 0;
    constexpr int steps = 30;
    for (int k = 0; k < steps; ++k)
        solves += contact.solve(state_at(1 + 0.02 * k), estimates, observer).force->iterations;
    CHECK(2 * solves <= 5 * steps);
}

TEST_CASE("Another friction shares what is cached") {
    const WheelRailContact contact(coarse_setup(Side::right));
    Observer observer;
    WheelRailSetup slippery = contact.setup();
    slippery.friction = WheelRailFriction{{{0, 0.05}}};
    const WheelRailContact other = contact.with_friction(*slippery.friction);
    CHECK(other.setup() == slippery);
    CHECK(other.solve(state_at(3), observer).forces.track ==
          WheelRailContact(slippery).solve(state_at(3), observer).forces.track);
}

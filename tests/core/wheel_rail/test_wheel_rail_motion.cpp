// Creepages, and what friction makes of them.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

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

// Elastic work comes back as a steady contact rolls through it: what friction takes is what the rigid motion gives.
TEST_CASE("Friction takes the power that the motion gives, but for an error that shrinks with the elements") {
    WheelRailState state;
    state.position = {2, 0, 0, 0.001};
    state.velocity = {20000, 0, 0, 0, 0, -20000 / 460.0};
    state.Fz = 80000;
    WheelRailSetup setup;
    setup.rigid_slip = GENERATE(RigidSlipKind::plane, RigidSlipKind::surfaces);
    double last = 0.4;
    for (const double size : {1.0, 0.5, 0.25}) {
        setup.dx = setup.dy = size;
        const WheelRailSolution solution = solve(setup, state);
        double taken = 0, given = 0;
        for (const WheelRailPatch& patch : solution.patches) {
            const Creepages& creepages = patch.place.creepages;
            const Forces& forces = patch.solution.forces;
            taken += patch.solution.frictional_power.value();
            given -=
                creepages.velocity * (creepages.xi * forces.Fx + creepages.eta * forces.Fy + creepages.phi * forces.Mz);
        }
        const double off = std::abs(taken / given - 1);
        INFO("elements of " << size << " mm: " << taken << " taken, " << given << " given");
        CHECK(taken > 0);
        CHECK(off < 0.6 * last);
        last = off;
    }
    CHECK(last < 0.06);
}

// S1002 on 60E1 at 1/20, yawed: at y = 6.12 to 6.14 mm one patch of three regions becomes two patches.
TEST_CASE("With the slip of the surfaces forces do not jump where patches part") {
    WheelRailSetup setup;
    setup.rail.shape = Rail60E1{1.0 / 20};
    setup.dx = setup.dy = 0.5;
    const auto forces_at = [&](double y) {
        WheelRailState state;
        state.position = {y, 0, 0, 0.005};
        state.velocity = {20000, 0, 0, 0, 0, -20000 / 460.0};
        state.Fz = 80000;
        return solve(setup, state).forces.track;
    };
    const auto largest_bend = [&] {
        double largest = 0;
        Wrench last = forces_at(6.08), here = forces_at(6.1);
        for (const double y : {6.12, 6.14, 6.16, 6.18}) {
            const Wrench next = forces_at(y);
            largest = std::max(largest, std::hypot(next.Fx - 2 * here.Fx + last.Fx, next.Fy - 2 * here.Fy + last.Fy));
            last = here;
            here = next;
        }
        return largest / (0.3 * 80000);
    };
    CHECK(largest_bend() > 0.1);
    setup.rigid_slip = RigidSlipKind::surfaces;
    CHECK(largest_bend() < 0.04);
}

TEST_CASE("On a single flat contact the slip of the surfaces is that of the plane") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.friction = WheelRailFriction{};
    WheelRailState state;
    state.position.yaw = 0.001;
    state.velocity = {10000, 0, 0, 0, 0, -10005 / 450.0};
    state.Fz = 20000;
    const Forces plane = solve(setup, state).patches.at(0).solution.forces;
    setup.rigid_slip = GENERATE(RigidSlipKind::surfaces, RigidSlipKind::elements);
    const Forces surfaces = solve(setup, state).patches.at(0).solution.forces;
    CHECK_THAT(surfaces.Fx, WithinAbs(plane.Fx, 5e-3 * 0.3 * 20000));
    CHECK_THAT(surfaces.Fy, WithinAbs(plane.Fy, 5e-3 * 0.3 * 20000));
    CHECK_THAT(surfaces.Fn, WithinRel(plane.Fn, 1e-12));  // Fz is, and forces along the plane have little part in it
}

// Rim and rail run through the contact with the same speed everywhere, if both are seen along the direction half-way
// between theirs.
TEST_CASE("A cylinder that rolls on the plane does not slip by the middles of its elements") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.friction = WheelRailFriction{};
    setup.rigid_slip = RigidSlipKind::elements;
    WheelRailState state;
    state.velocity = {10000, 0, 0, 0, 0, -10000 / 450.0};
    state.Fz = 100000;
    const WheelRailPatch patch = solve(setup, state).patches.at(0);
    const double by_approach = patch.place.approach / 450;
    CHECK(by_approach > 1e-4);
    CHECK_THAT(patch.place.creepages.xi, WithinAbs(0, 1e-3 * by_approach));
    CHECK_THAT(patch.solution.forces.Fx, WithinAbs(0, 1e-3 * 0.3 * 100000));
}

// Where wheels, rails and rollers lie by the functions of the library, and what follows from that.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "client/cntc/rail_calls.hpp"

using namespace contactd;
using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double of_rail = 300, incline = 0.05;  // of the wheel's cone
constexpr int slip_of_surfaces = 3, curved = 4, plane = 2, mesh = 5;

/// A cone on an arc, whose points lie beside y = 0.
RailCase cone_on_arc(Side side, int surfaces = plane) {
    RailCase rail(1);
    rail.whole.flag(1967, side == Side::left ? 0 : 1);
    rail.whole.flag(1977, surfaces);
    rail.whole.material(0.28, 0.28, 82000, 82000);
    rail.whole.coulomb(0.3);
    rail.whole.potential(-1, {0.5, 0.5, 1.5707963267948966, 8, 4, 12});
    Values arc, cone;
    for (double y = -30.1; y < 30; y += 0.6) {
        arc.insert(arc.end(), {y, of_rail - std::sqrt(of_rail * of_rail - y * y)});
        cone.insert(cone.end(), {y, -incline * y});
    }
    rail.profile(false, arc);
    rail.profile(true, cone);
    rail.track(3, {0, side == Side::left ? -750.0 : 750.0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    rail.wheelset(3, {1360, -70, 430});
    rail.position(2, {0, 0, 0, 0, 0, 0});
    rail.velocity(2, {2000, 0, 0, 0, 0, -2000 / 430.0});
    rail.vertical_force(10000);
    return rail;
}

}  // namespace

TEST_CASE("lengths along profiles are counted from y = 0, on a wheel towards its flange") {
    const Side side = GENERATE(Side::left, Side::right);
    RailCase rail = cone_on_arc(side);
    REQUIRE(rail.whole.calculate() == 0);
    const Values at = rail.location(1);
    const double outwards = side == Side::left ? -1 : 1, on_rail = outwards * at[5], on_wheel = outwards * at[10];
    CHECK(on_rail < -10);
    CHECK_THAT(at[7], WithinAbs(of_rail * std::asin(on_rail / of_rail), 1e-4));
    CHECK_THAT(at[12], WithinAbs(-on_wheel * std::hypot(1, incline), 1e-4));
}

TEST_CASE("a large roller with cant stands as the rail with it") {
    const Side side = GENERATE(Side::left, Side::right);
    constexpr double cant = 0.03, of_roller = 1e5;
    const double y = side == Side::left ? -750 : 750;
    RailCase rail = cone_on_arc(side);
    rail.track(1, {0, y, 0, cant, 0});
    REQUIRE(rail.whole.calculate() == 0);
    const Values of_the_rail = rail.location(1), on_the_rail = rail.global_forces();
    RailCase roller = cone_on_arc(side);
    roller.whole.flag(1967, side == Side::left ? 4 : 5);
    roller.track(1, {0, y, 0, cant, of_roller});
    roller.velocity(2, {2000 / of_roller, 0, 0, 0, 0, -2000 / 430.0});
    REQUIRE(roller.whole.calculate() == 0);
    const Values at = roller.location(1), forces = roller.global_forces();
    // The wheel leans by its cone, the profile by its cant less.
    const double leans = -std::atan(incline) + cant;
    CHECK_THAT(at[8] * (side == Side::left ? -1 : 1), WithinAbs(leans, 1e-4));
    CHECK_THAT(at[1], WithinAbs(of_the_rail[1], 1e-3));
    CHECK_THAT(at[27], WithinAbs(of_the_rail[27], 1e-12));
    CHECK_THAT(forces[0], WithinAbs(on_the_rail[0], 1e-3 * 10000));
    CHECK_THAT(forces[1], WithinAbs(on_the_rail[1], 1e-3 * 10000));
}

TEST_CASE("a wheel that is displaced along the track slips as another program has it") {
    const Side side = GENERATE(Side::left, Side::right);
    const int surfaces = GENERATE(plane, mesh, slip_of_surfaces, curved);
    constexpr double ahead = 3;
    RailCase rail = cone_on_arc(side, surfaces);
    REQUIRE(rail.whole.calculate() == 0);
    const auto creepages = rail.patch(1).found_creepages();
    const Values before = rail.global_forces();
    rail.flexibility(5, {ahead, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    REQUIRE(rail.whole.calculate() == 0);
    const auto displaced = rail.patch(1).found_creepages();
    const Values forces = rail.global_forces();
    if (surfaces == slip_of_surfaces || surfaces == curved) {
        // The axle that it turns about goes along.
        CHECK_THAT(displaced.vy, WithinAbs(creepages.vy, 1e-7));
        CHECK_THAT(forces[1], WithinAbs(before[1], 1));
        return;
    }
    // The rim goes down there, about the axle of the rigid wheelset.
    const double down = ahead / 430, outwards = side == Side::left ? -1 : 1;
    CHECK_THAT(displaced.vy - creepages.vy, WithinRel(outwards * std::sin(std::atan(incline)) * down, 5e-3));
}

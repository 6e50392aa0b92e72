// Tests wheels that are displaced from a rigid wheelset: both searches find the same positions.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

#include "contactd/make_profile.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double wheel_radius = 430, roller_radius = 600, side = 760;

/// Creates a cone of 1/20 on a crown of 250 mm.
WheelRailSetup cone_on_crown() {
    WheelRailSetup setup;
    setup.wheel.shape = ConeProfile{-0.05, -30, 30};
    setup.rail.shape = ArcProfile{250, 0, -30, 30};
    setup.track.rail_origin = ProfilePoint{side, 0};
    setup.wheelset = {2 * side, 0, wheel_radius};
    setup.friction.reset();
    setup.dx = setup.dy = 0.3;
    return setup;
}

WheelRailSetup on_roller() {
    WheelRailSetup setup = cone_on_crown();
    setup.track.roller_radius = roller_radius;
    return setup;
}

/// Creates the crown by slices whose heights are those of a roller, at y = 0.
WheelRailSetup on_slices() {
    WheelRailSetup setup = cone_on_crown();
    const ProfileCurve crown = make_profile(setup.rail).curve;
    for (double x = -80; x <= 80; x += 2) {
        ProfilePoints points;
        const double fall = roller_radius - std::sqrt(roller_radius * roller_radius - x * x);
        for (const ProfilePoint& point : crown.points()) points.points.push_back({point.y, point.z + fall});
        setup.rail_slices.push_back({x, {ProfileKind::rail, points}});
    }
    return setup;
}

/// Creates a wheel with equal slices, which is searched for on a mesh.
WheelRailSetup of_equal_slices(WheelRailSetup setup) {
    for (const double angle : {-0.5, 0.0, 0.5}) setup.wheel_slices.push_back({angle, setup.wheel});
    return setup;
}

struct Found {
    double height;
    ContactPlace place;
};

/// Returns the only contact of a wheel 0.02 mm below the height of first contact.
Found pressed(const WheelRailSetup& setup, WheelRailState state) {
    const WheelRailContact contact(setup);
    const double height = contact.first_contact_height(state).value();
    state.position.z = height + 0.02;
    const WheelRailGeometry geometry = contact.locate(state);
    REQUIRE(geometry.places.size() == 1);
    return {height, geometry.places[0]};
}

WheelRailState with(const WheelDeviation& wheel) {
    WheelRailState state;
    state.wheel = wheel;
    return state;
}

}  // namespace

TEST_CASE("A wheel ahead of its place touches a roller on the line from axle to axle") {
    WheelRailSetup setup = on_roller();
    setup.side = GENERATE(Side::left, Side::right);
    setup.patches.search = GENERATE(ContactSearch::locus, ContactSearch::mesh);
    const double ahead = GENERATE(-20.0, 8.0, 20.0);
    const Found found = pressed(setup, with({.x = ahead}));
    // A cone of 1/20 touches a crown of 250 mm 0.31 mm below its top, where the wheel is 0.62 mm larger.
    const double aside = 250 * std::sin(std::atan(0.05)), sunk = 250 * (1 - std::cos(std::atan(0.05)));
    const double roller = roller_radius - sunk, wheel = wheel_radius + 0.05 * aside;
    CHECK_THAT(found.place.reference.x, WithinAbs(ahead * roller / (roller + wheel), 2e-3));
    CHECK_THAT(std::abs(found.place.reference.y), WithinAbs(side - aside, 2e-2));
    const double rise = roller + wheel - std::sqrt(std::pow(roller + wheel, 2) - ahead * ahead);
    CHECK_THAT(found.height, WithinAbs(pressed(setup, {}).height + rise, 1e-4));
}

TEST_CASE("Both searches find a wheel that is out of its place where it is") {
    WheelRailSetup setup = GENERATE(cone_on_crown(), on_roller(), on_slices());
    const WheelDeviation out = GENERATE(WheelDeviation{}, WheelDeviation{.x = 8}, WheelDeviation{.x = -20},
                                        WheelDeviation{.y = 3}, WheelDeviation{.z = -2}, WheelDeviation{.roll = 0.02},
                                        WheelDeviation{.yaw = 0.01}, WheelDeviation{.yaw = -0.02},
                                        WheelDeviation{.pitch = 0.3}, WheelDeviation{5, 2, 1, 0.01, -0.015, 0.2});
    WheelRailState state = with(out);
    state.position.yaw = GENERATE(0.0, 0.008);
    CAPTURE(setup.track.roller_radius.has_value(), setup.rail_slices.size(), out.x, out.y, out.z, out.roll, out.yaw,
            out.pitch, state.position.yaw);
    setup.patches.search = ContactSearch::locus;
    const Found locus = pressed(setup, state);
    setup.patches.search = ContactSearch::mesh;
    for (const WheelRailSetup& other : {setup, of_equal_slices(setup)}) {
        const Found mesh = pressed(other, state);
        CHECK_THAT(mesh.place.reference.x, WithinAbs(locus.place.reference.x, 0.02));
        CHECK_THAT(mesh.place.reference.y, WithinAbs(locus.place.reference.y, 0.02));
        CHECK_THAT(mesh.place.reference.angle, WithinAbs(locus.place.reference.angle, 2e-4));
        CHECK_THAT(mesh.height, WithinAbs(locus.height, 2e-4));
        CHECK_THAT(mesh.place.penetration, WithinAbs(locus.place.penetration, 2e-4));
    }
}

TEST_CASE("A wheel out of its place carries its load on a roller and on slices bent alike") {
    WheelRailSetup setup = GENERATE(on_roller(), on_slices());
    WheelRailState state = with(GENERATE(WheelDeviation{.x = 20}, WheelDeviation{.yaw = 0.01}));
    state.Fz = 30000;
    setup.patches.search = ContactSearch::mesh;
    const WheelRailSolution mesh = solve(setup, state);
    setup.patches.search = ContactSearch::locus;
    const WheelRailSolution locus = solve(setup, state);
    REQUIRE(locus.converged());
    REQUIRE(locus.patches.size() == 1);
    CHECK_THAT(locus.forces.track.Fz, WithinRel(30000.0, 1e-5));
    CHECK_THAT(locus.z, WithinAbs(mesh.z, 2e-4));
    CHECK_THAT(locus.patches[0].place.reference.x, WithinAbs(mesh.patches[0].place.reference.x, 0.03));
    CHECK_THAT(locus.patches[0].solution.pmax, WithinRel(mesh.patches[0].solution.pmax, 5e-3));
}

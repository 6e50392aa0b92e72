// Tests rollers whose surface is inclined with their axle.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "closed_forms/hertz.hpp"
#include "contactd/make_profile.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::geometry;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double radius = 300, roll = 0.2;

RailSurface cylinder(bool leans, double lower, double cant = 0) {
    Track track;
    track.cant = cant;
    track.rail_origin = ProfilePoint{750, 2};
    track.roller_radius = radius;
    track.roller_leans = leans;
    RailDeviation deviation;
    deviation.roll = roll + cant;
    deviation.z = lower;
    return {make_profile({ProfileKind::rail, ConeProfile{0, -40, 40}}).curve, track, *track.rail_origin, deviation};
}

}  // namespace

TEST_CASE("A cylinder that leans is the cylinder about its axle that leans") {
    const double lower = GENERATE(0.0, 0.5), x = GENERATE(-20.0, 0.0, 7.0), y = GENERATE(740.0, 755.0);
    const RailSurface rail = cylinder(true, lower);
    const double axle_y = 750 - radius * std::sin(roll), axle_z = 2 + lower + radius * std::cos(roll);
    // Returns the distance of a point of the surface from the plane through the axle and the track's x.
    const double outwards = std::sqrt(radius * radius - x * x);
    const double z = axle_z + (std::sin(roll) * (y - axle_y) - outwards) / std::cos(roll);
    CHECK_THAT(rail.height(x, y, 0), WithinAbs(z, 1e-8));
    const double h = 1e-3;
    CHECK_THAT(rail.slope_along(x, y, rail.height(x, y, 0)),
               WithinAbs((rail.height(x + h, y, 0) - rail.height(x - h, y, 0)) / (2 * h), 1e-5));
}

TEST_CASE("A roller leans against its cant as it leans by its roll") {
    const double x = GENERATE(-20.0, 0.0, 7.0), y = GENERATE(740.0, 755.0);
    CHECK_THAT(cylinder(true, 0.5, 0.05).height(x, y, 0), WithinAbs(cylinder(true, 0.5).height(x, y, 0), 1e-9));
}

TEST_CASE("A roller that leans turns about a level axle that does not move with it") {
    CHECK(cylinder(true, 0.5).axle() == 2 + radius);
    CHECK(cylinder(false, 0.5).axle() == 2.5 + radius);
}

TEST_CASE("A leaning torus under a cylinder is Hertz's contact with its curvature along the track") {
    constexpr double across = 100, lean = 0.25, wheel = 450, Fn = 60000;
    WheelRailSetup setup = cylinder_on_arc(across);
    setup.rail.shape = ArcProfile{across, 0, -40, 40};
    setup.dx = setup.dy = 0.2;
    setup.track.roller_radius = 100;
    setup.track.roller_leans = true;
    WheelRailState state;
    state.rail.roll = lean;
    state.Fz = Fn;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.converged());
    REQUIRE(solution.patches.size() == 1);
    // Uses the local radius, and Meusnier's theorem for a plane inclined against the circle's.
    const double circle = 100 - across * (1 - std::cos(lean));
    const double along = 1 / (1 / wheel + std::cos(lean) / circle);
    const HertzContact known = hertz_of_force({along, across}, setup.bodies.materials().normal_compliance(), Fn);
    CHECK_THAT(solution.patches[0].solution.pmax, WithinRel(known.pmax, 5e-3));
    CHECK_THAT(solution.patches[0].solution.approach, WithinRel(known.approach, 2e-3));
}

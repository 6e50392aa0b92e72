// Tests the origin of lengths across a rail.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/make_profile.hpp"
#include "geometry/search/patch_grid.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

/// Returns points of a circle every 0.7 mm, none at y = 0.
ProfilePoints circle_beside_its_top(double of_rail, double first) {
    ProfilePoints points;
    for (double y = first; y <= 30; y += 0.7)
        points.points.push_back({y, of_rail - std::sqrt(of_rail * of_rail - y * y)});
    return points;
}

}  // namespace

TEST_CASE("Lengths across a rail are counted from y = 0, wherever its points lie") {
    constexpr double of_rail = 100;
    WheelRailSetup setup = cylinder_on_arc(of_rail);
    setup.side = GENERATE(Side::left, Side::right);
    setup.rail.shape = circle_beside_its_top(of_rail, GENERATE(-30.0, -29.95, -30.3));
    setup.wheel.shape = ConeProfile{-0.05, -40, 40};
    WheelRailState state;
    state.Fz = 10'000;
    state.motion = GENERATE(WheelRailMotion::steady_rolling, WheelRailMotion::shift);
    if (state.motion == WheelRailMotion::shift) state.time_step = 1;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.patches.size() == 1);
    const ContactPlace& place = solution.patches[0].place;
    const double outwards = setup.side == Side::right ? 1 : -1;
    const double y = outwards * place.reference.y - 750;
    CHECK(std::abs(y) > 4);
    CHECK_THAT(place.on_rail.across, WithinAbs(outwards * of_rail * std::asin(y / of_rail), 1e-4));
    if (state.motion != WheelRailMotion::shift) return;
    // Elements have their middles at multiples of their width from there.
    const double rows = (place.on_rail.across + place.grid.y(0)) / place.grid.dy;
    CHECK_THAT(rows, WithinAbs(std::round(rows), 1e-6));
}

TEST_CASE("Lengths along a profile that ends before y = 0 are counted from its end") {
    const ProfileCurve beside({{5, 1}, {10, 1}, {20, 1}});
    CHECK_THAT(geometry::arc_length_of_middle(beside), WithinAbs(0, 1e-12));
    const ProfileCurve before({{-20, 1}, {-10, 1}, {-5, 1}});
    CHECK_THAT(geometry::arc_length_of_middle(before), WithinAbs(15, 1e-12));
}

TEST_CASE("Lengths along a profile that doubles back are counted from the point nearest to the origin") {
    // Creates a head with or without its lower sides.
    const bool doubles_back = GENERATE(true, false);
    ProfilePoints head;
    if (doubles_back) head.points = {{-34, 14}, {-35, 11}};
    for (const auto& [y, z] : {std::pair(-36.0, 8.0), {-30, 2}, {-10.2, 0.1}, {-0.15, 0}, {0.4, 0}, {10, 0.2}, {30, 2}})
        head.points.push_back({y, z});
    const ProfileCurve curve = make_profile({ProfileKind::rail, head}).curve;
    REQUIRE(curve.points().front().y == -36);
    CHECK_THAT(geometry::arc_length_of_middle(curve),
               WithinAbs(curve.arc_length(curve.s_at_y(doubles_back ? -0.15 : 0)), 1e-9));
    const ProfileCurve mirrored = curve.mirrored();
    CHECK_THAT(mirrored.at(mirrored.middle()).y, WithinAbs(doubles_back ? 0.15 : 0, 1e-9));
}

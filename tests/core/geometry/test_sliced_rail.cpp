// Tests rails that vary along the track.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "closed_forms/hertz.hpp"
#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "geometry/placement/sliced_rail.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using Slice = geometry::SlicedRail::Slice;

/// Returns the points of a profile, raised by `lift` and displaced.
ProfileSpec moved(const ProfileSpec& spec, double lift, double aside = 0) {
    ProfilePoints points;
    const ProfileCurve curve = make_profile(spec).curve;
    for (const ProfilePoint& point : curve.points()) points.points.push_back({point.y + aside, point.z - lift});
    return {ProfileKind::rail, points};
}

WheelRailSetup sliced(const WheelRailSetup& plain, double rise) {
    WheelRailSetup setup = plain;
    for (const double x : {-200.0, -60.0, 50.0, 210.0}) setup.rail_slices.push_back({x, moved(plain.rail, rise * x)});
    return setup;
}

}  // namespace

TEST_CASE("Between slices a point goes along a smooth spline") {
    const ProfileSpec arc{ProfileKind::rail, ArcProfile{300, 0, -30, 30}};
    std::vector<Slice> slices;
    for (int i = 0; i < 9; ++i) {
        const double x = 25.0 * i;
        slices.push_back({x, make_profile(moved(arc, 2 * std::sin(x / 60))).curve});
    }
    const geometry::SlicedRail rail(slices);
    const double at = GENERATE(87.0, 112.5, 75.0);
    const ProfileCurve curve = rail.at(at);
    CHECK_THAT(curve.at(curve.s_at_y(0)).z, WithinAbs(-2 * std::sin(at / 60), 2e-3));
    const ProfileCurve beyond = rail.at(900);
    CHECK_THAT(beyond.at(beyond.s_at_y(0)).z, WithinAbs(-2 * std::sin(slices.back().x / 60), 1e-6));
}

TEST_CASE("Between slices that are equal nothing changes, wherever others differ from them") {
    const ProfileSpec low = moved({ProfileKind::rail, Rail60E1{1.0 / 40}}, 0), high = moved(low, 0.1);
    const double apart = GENERATE(10.0, 100.0);
    std::vector<Slice> slices;
    for (const ProfileSpec& slice : {low, low, low, high, high, high})
        slices.push_back({apart * static_cast<double>(slices.size()), make_profile(slice).curve});
    const geometry::SlicedRail rail(slices);
    const auto top = [&](double share) {
        const ProfileCurve curve = rail.at(share * apart);
        return curve.at(curve.s_at_y(3)).z;
    };
    for (const double share : {0.3, 1.0, 1.5, 1.9, 2.0}) CHECK(top(share) == top(0));
    for (const double share : {3.0, 3.2, 3.5, 4.4, 5.0}) CHECK(top(share) == top(5));
    CHECK_THAT(top(5), WithinAbs(top(0) - 0.1, 1e-9));
    for (double share = 2; share < 3; share += 0.05) CHECK(top(share + 0.05) <= top(share) + 1e-12);
}

/// Returns the field that a refusal names; empty without a refusal.
template <class Act>
std::string refused(const Act& act) {
    try {
        act();
        return "";
    } catch (const InvalidArgument& error) {
        return error.field();
    }
}

/// Creates a flat top from y = 0 to `width`, with a step up of 10 mm there and 30 mm of flat beyond.
ProfileCurve step_at(double width) {
    return ProfileCurve({{0, 10}, {0.5 * width, 10}, {width, 10}, {width + 0.01, 0}, {width + 15, 0}, {width + 30, 0}},
                        {2, 3});
}

TEST_CASE("Features are joined to straight lines, whatever lies between them") {
    // The step moves sideways by 1 in 10. Kinks would suffice here, but the first profile has one kink more.
    std::vector<Slice> slices;
    for (const double x : {0.0, 50.0, 100.0, 150.0})
        slices.push_back({x, step_at(30 + x / 10), {0, 30 + x / 10, 40 + x / 10, 999}});
    slices[0].curve =
        ProfileCurve({{0, 10}, {10, 10}, {10.01, 9}, {10.02, 10}, {30, 10}, {30.01, 0}, {60, 0}}, {1, 2, 3, 4, 5});
    slices[0].features = {0, 32, 42, 999};
    const geometry::SlicedRail rail(slices);
    for (const double x : {62.0, 75.0, 120.0}) {
        const ProfileCurve curve = rail.at(x);
        const double edge = 30 + x / 10;
        CHECK_THAT(curve.at(curve.s_at_y(edge - 1)).z, WithinAbs(10, 1e-6));
        CHECK_THAT(curve.at(curve.s_at_y(edge + 5)).z, WithinAbs(0, 0.02));
        CHECK_THAT(curve.points().back().y, WithinAbs(edge + 30, 0.1));
    }
}

TEST_CASE("A part begins at the first slice that has it and ends at the last one") {
    std::vector<Slice> slices;
    for (const double x : {0.0, 50.0, 100.0, 150.0, 200.0}) slices.push_back({x, step_at(30), {0, 30, 40, 999}});
    slices[0].features = {0, 30, -1, -1};  // the lower flat alone
    slices[1].features = {0, 30, -1, -1};
    slices[4].features = {-1, 30, 40, 999};  // all except the lower flat
    const geometry::SlicedRail rail(slices);
    const auto ends = [&](double x) {
        const ProfileCurve curve = rail.at(x);
        return std::pair(curve.points().front().y, curve.points().back().y);
    };
    for (const double x : {-20.0, 20.0, 99.0}) CHECK_THAT(ends(x).second, WithinAbs(30, 1e-6));
    for (const double x : {-20.0, 20.0, 99.0}) CHECK(ends(x).first == 0);
    for (const double x : {100.0, 120.0, 149.0}) CHECK(ends(x).first == 0);
    for (const double x : {100.0, 120.0, 149.0, 180.0, 300.0}) CHECK_THAT(ends(x).second, WithinAbs(60, 1e-6));
    for (const double x : {150.0, 180.0, 300.0}) CHECK_THAT(ends(x).first, WithinAbs(30, 1e-6));
}

TEST_CASE("Features that make no rail are refused") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.rail_slices = {{0, setup.rail, {0, 10, 20}}, {50, setup.rail, {0, 10, 20}}};
    CHECK_NOTHROW(WheelRailContact(setup));
    const auto with = [&](std::vector<double> features) {
        WheelRailSetup other = setup;
        other.rail_slices[1].features = std::move(features);
        return refused([&] { WheelRailContact contact(other); });
    };
    CHECK(with({0, 10}) == "rail_slices[1].features");
    CHECK(with({}) == "rail_slices[1].features");
    CHECK(with({-1, -1, 10}) == "rail_slices[1].features");
    CHECK(with({0, 10, 10}) == "rail_slices[1].features[2]");
    CHECK(with({0, -1, 10}) == "rail_slices[1].features[2]");
    CHECK(with({0, 500, 600}) == "rail_slices[1].features[1]");
    CHECK(with({-1, 0, 10}) == "");
    setup.rail_slices[0].features = {0, 10, -1};
    CHECK(with({-1, 0, 10}) == "rail_slices[1].features");
}

TEST_CASE("Slices with other parts than the first one are refused") {
    const ProfileSpec smooth{ProfileKind::rail, ProfilePoints{{{-30, 2}, {-15, 0.5}, {0, 0}, {15, 0.5}, {30, 2}}}};
    const ProfileSpec kinked{ProfileKind::rail, ProfilePoints{{{-30, 20}, {-15, 10}, {0, 0}, {15, 0.5}, {30, 2}}}};
    REQUIRE(make_profile(kinked).curve.kinks().size() == 1);
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.rail_slices = {{0, smooth}, {50, smooth}, {100, kinked}};
    CHECK_THROWS_WITH(
        WheelRailContact(setup),
        ContainsSubstring("rail_slices[2].profile has 2 parts between kinks, but the first slice has 1;"));
    setup.rail_slices = {{0, kinked}, {50, kinked}};
    CHECK_NOTHROW(WheelRailContact(setup));
}

TEST_CASE("Slices that are all the same are a rail") {
    WheelRailSetup setup;
    setup.track.rail_origin = ProfilePoint{760, 0};
    setup.dx = setup.dy = 0.4;
    WheelRailState state;
    state.position = {GENERATE(2.0, 6.5), 0, 0.0005, 0.01};
    state.position.x = 17;
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 60000;
    const WheelRailSolution plain = solve(setup, state), same = solve(sliced(setup, 0), state);
    CHECK_THAT(same.z, WithinAbs(plain.z, 2e-4));  // points of slices are at other positions of the curve
    CHECK_THAT(same.forces.track.Fx, WithinAbs(plain.forces.track.Fx, 0.01 * 18000));
    CHECK_THAT(same.forces.track.Fy, WithinAbs(plain.forces.track.Fy, 0.01 * 18000));
    REQUIRE(same.patches.size() == plain.patches.size());
    CHECK_THAT(same.patches[0].place.reference.y, WithinAbs(plain.patches[0].place.reference.y, 0.1));
}

TEST_CASE("On a rail that rises a wheel touches ahead of its centre") {
    const double rise = 0.01;
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 0.4;
    WheelRailState state;
    state.Fz = 40000;
    const WheelRailSolution level = solve(setup, state), rising = solve(sliced(setup, rise), state);
    REQUIRE(rising.patches.size() == 1);
    const double angle = std::atan(rise);
    CHECK_THAT(rising.patches[0].place.reference.x, WithinRel(450 * std::sin(angle), 2e-3));
    // The rail's surface is higher there, and so is the wheel's rim.
    const double lift = 450 / std::cos(angle) - 450;
    CHECK_THAT(rising.z, WithinAbs(level.z - lift, 2e-4));
    CHECK_THAT(rising.patches[0].solution.pmax, WithinRel(level.patches[0].solution.pmax, 5e-3));
}

TEST_CASE("A rail of one cross-section presses as one between any slices, whatever their heights and places") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 0.4;
    setup.rail_spline = GENERATE(SliceSpline::shape_preserving, SliceSpline::cubic, SliceSpline::approximating);
    const bool ramp = GENERATE(true, false);  // or a rail that is displaced sideways, and dips
    const std::vector<double> places{-3000, -200, 0, 200, 1800, 2000, 2200, 5000};
    const std::vector<double> lift{0, 0, 0, 0.2, 1.8, 2, 2, 2}, dip{0, 0, 0, -0.1, -0.9, 0, 0, 0};
    const std::vector<double> aside{0, 0, 0, 1, 9, 10, 10, 10};
    for (std::size_t i = 0; i < places.size(); ++i)
        setup.rail_slices.push_back(
            {places[i], moved(cylinder_on_arc(300).rail, ramp ? lift[i] : dip[i], ramp ? 0 : aside[i])});
    const HertzContact known = hertz_of_force({450, 300}, setup.bodies.materials().normal_compliance(), 80000);
    WheelRailState state;
    state.Fz = 80000;
    for (const double x : {-1600.0, -1000.0, 500.0, 1000.0, 1500.0, 3000.0}) {
        state.position.x = x;
        const WheelRailSolution solution = solve(setup, state);
        CAPTURE(x, setup.rail_spline, ramp);
        REQUIRE(solution.patches.size() == 1);
        CHECK_THAT(solution.patches[0].solution.pmax, WithinRel(known.pmax, 0.01));
        if (ramp) CHECK_THAT(solution.patches[0].place.reference.y, WithinAbs(750, 1e-2));
    }
}

TEST_CASE("A rail that moves aside takes the contact along") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 0.4;
    const ProfileSpec rail = setup.rail;
    for (const double x : {0.0, 1000.0}) setup.rail_slices.push_back({x, moved(rail, 0, 0.01 * x)});
    WheelRailState state;
    state.Fz = 40000;
    for (const double x : {100.0, 700.0}) {
        state.position.x = x;
        const WheelRailSolution solution = solve(setup, state);
        REQUIRE(solution.patches.size() == 1);
        CHECK_THAT(solution.patches[0].place.reference.y, WithinAbs(750 + 0.01 * x, 2e-3));
    }
}

TEST_CASE("Slices that make no rail are refused by name") {
    const auto refused = [](const WheelRailSetup& setup, const std::string& sentence) {
        CHECK_THROWS_AS(WheelRailContact(setup), InvalidArgument);
        CHECK_THROWS_WITH(WheelRailContact(setup), ContainsSubstring(sentence));
    };
    WheelRailSetup setup;
    setup.rail_slices = {{0}};
    refused(setup, "rail_slices has one slice");
    setup.rail_slices = {{0}, {0}};
    refused(setup, "rail_slices[1].x is 0");
    setup.rail_slices = {{0}, {10}};
    refused(setup, "track.rail_origin is missing");
    setup.track.rail_origin = ProfilePoint{760, 0};
    setup.rail_slices[1].profile.shape = ProfilePoints{{{0, 0}}};
    refused(setup, "rail_slices[1].profile.points");
}

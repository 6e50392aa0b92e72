// Tests overlap on a mesh seen from above.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>
#include <tuple>

#include "closed_forms/hertz.hpp"
#include "contactd/make_profile.hpp"
#include "wheel_rail/manchester.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Creates a cylinder of 450 mm on an arc of 300 mm whose top is lower by depth(x).
template <class Depth>
WheelRailSetup on_rail_of_depth(const Depth& depth, double from = -100, double to = 100, double step = 5) {
    WheelRailSetup setup = cylinder_on_arc(300);
    const ProfileCurve arc = make_profile(setup.rail).curve;
    for (double x = from; x <= to; x += step) {
        ProfilePoints points;
        for (const ProfilePoint& point : arc.points()) points.points.push_back({point.y, point.z + depth(x)});
        setup.rail_slices.push_back({x, {ProfileKind::rail, points}});
    }
    setup.patches.search = ContactSearch::mesh;
    return setup;
}

bool warns(const WheelRailSolution& solution, const std::string& part) {
    return std::any_of(solution.warnings.begin(), solution.warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("On a rail that is the same all along both searches find the same contact") {
    const ManchesterCase known = manchester_cases[GENERATE(range(0, 22, 3))];
    WheelRailSetup setup = manchester_setup(known.side);
    const WheelRailSolution locus = solve(setup, manchester_state(known));
    setup.patches.search = ContactSearch::mesh;
    const WheelRailSolution mesh = solve(setup, manchester_state(known));
    INFO((known.side == Side::left ? "left " : "right ") << known.number);
    REQUIRE(mesh.converged());
    REQUIRE(mesh.patches.size() == locus.patches.size());
    const ContactReference &a = mesh.patches[0].place.reference, &b = locus.patches[0].place.reference;
    CHECK_THAT(a.x, WithinAbs(b.x, 0.05));
    CHECK_THAT(a.y, WithinAbs(b.y, 0.02));
    CHECK_THAT(a.angle, WithinAbs(b.angle, 1e-3));
    CHECK_THAT(mesh.z, WithinAbs(locus.z, 1e-4));
    CHECK_THAT(mesh.patches[0].solution.pmax, WithinRel(locus.patches[0].solution.pmax, 5e-3));
}

TEST_CASE("A small wheel in a sharp yaw touches where its middle has gone to") {
    WheelRailSetup setup = manchester_setup(GENERATE(Side::left, Side::right));
    setup.wheelset.nominal_radius = 100;
    WheelRailState state;
    state.position.yaw = GENERATE(-0.12, -0.035, 0.035, 0.12);
    state.position.y = GENERATE(-6.0, 0.0, 6.0);
    state.Fz = 20000;
    CAPTURE(setup.side, state.position.yaw, state.position.y);
    const WheelRailSolution locus = solve(setup, state);
    setup.patches.search = ContactSearch::mesh;
    const WheelRailSolution mesh = solve(setup, state);
    REQUIRE(mesh.converged());
    CHECK_THAT(mesh.z, WithinAbs(locus.z, 1e-3));
    REQUIRE(mesh.patches.size() == 1);
    CHECK_THAT(mesh.patches[0].place.reference.x, WithinAbs(locus.patches.at(0).place.reference.x, 0.2));
}

TEST_CASE("A rail that curves along the track is a body with two radii") {
    const double radius = GENERATE(300.0, 1000.0, -2000.0);
    WheelRailSetup setup =
        on_rail_of_depth([&](double x) { return radius - std::copysign(std::sqrt(radius * radius - x * x), radius); });
    setup.dx = setup.dy = 0.25;
    setup.model = GENERATE(Model::full, Model::hertz);
    WheelRailState state;
    state.Fz = 30000;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.converged());
    REQUIRE(solution.patches.size() == 1);
    const double along = 1 / (1.0 / 450 + 1 / radius);
    const HertzContact hertz = hertz_of_force({along, 300}, (1 - 0.28) / 82000, 30000);
    CHECK_THAT(solution.patches[0].solution.pmax, WithinRel(hertz.pmax, 0.01));
    CHECK_THAT(solution.patches[0].solution.approach, WithinRel(hertz.approach, 0.01));
    CHECK_THAT(1 / solution.patches[0].place.radii.rail_along, WithinAbs(1 / radius, 2e-5));
    CHECK(!warns(solution, "curvature of the rail along the track"));
}

TEST_CASE("The search along the locus says where the rail curves too much for it") {
    WheelRailSetup setup = on_rail_of_depth([](double x) { return x * x / 2000; });
    setup.dx = setup.dy = 0.4;
    setup.patches.search = ContactSearch::locus;
    WheelRailState state;
    state.Fz = 30000;
    CHECK(warns(solve(setup, state), "Set patches.search to mesh"));
}

TEST_CASE("A wheel above a dip rests on both of its sides") {
    const double period = 40, depth = 0.6;  // mm
    WheelRailSetup setup = on_rail_of_depth(
        [&](double x) {
            return std::abs(x) < period / 2 ? depth / 2 * (1 + std::cos(2 * std::numbers::pi * x / period)) : 0;
        },
        -60, 60, 2);
    setup.dx = setup.dy = 0.3;
    WheelRailState state;
    state.Fz = 20000;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.converged());
    REQUIRE(solution.patches.size() == 2);
    const auto& [first, second] = std::tie(solution.patches[0], solution.patches[1]);
    CHECK_THAT(first.place.reference.x, WithinAbs(-second.place.reference.x, 1e-6));
    CHECK(std::abs(first.place.reference.x) > 5);
    CHECK_THAT(first.forces.track.Fz, WithinRel(10000, 1e-5));
    CHECK_THAT(second.forces.track.Fz, WithinRel(10000, 1e-5));

    // Elsewhere along the track there is one patch again.
    state.position.x = 45;
    CHECK(solve(setup, state).patches.size() == 1);
}

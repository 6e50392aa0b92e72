// Tests out-of-round wheels on their rails.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "closed_forms/hertz.hpp"
#include "contactd/error.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi, R = 450;

/// Creates the cylinder on an arc, with the radius R + radius(angle), by slices at distances of `step` up to `to` on
/// both sides.
WheelRailSetup out_of_round(const std::function<double(double)>& radius, double step, double to) {
    WheelRailSetup setup = cylinder_on_arc(300);
    const int most = static_cast<int>(std::lround(to / step));
    for (int i = -most; i <= most; ++i) {
        if (i * step >= 2 * pi - most * step - 1e-9) break;  // the first one again
        const double z = radius(i * step);
        setup.wheel_slices.push_back({i * step, {ProfileKind::wheel, ProfilePoints{{{-40, z}, {0, z}, {40, z}}}}});
    }
    setup.dx = setup.dy = 0.25;
    return setup;
}

/// Returns the change of the radius R by an arc of another radius through the lowest point, up to 0.2 rad, and constant
/// beyond.
double of_arc(double angle, double radius) {
    const double at = std::min(std::abs(angle), 0.2), centre = R - radius, aside = centre * std::sin(at);
    return centre * std::cos(at) + std::sqrt(radius * radius - aside * aside) - R;
}

double of_flat(double angle, double depth) {
    return std::abs(angle) < 1 ? std::min(0.0, (R - depth) / std::cos(angle) - R) : 0;
}

double first_contact_height(const WheelRailSetup& setup, double pitch) {
    WheelRailState state;
    state.position.pitch = pitch;
    return WheelRailContact(setup).first_contact_height(state).value();
}

}  // namespace

TEST_CASE("A wheel of slices that are all the same is a surface of revolution") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.4;
    setup.patches.search = ContactSearch::mesh;
    WheelRailState state;
    state.position = {GENERATE(-4.0, 6.5), 0, 0.001, 0.012};
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 80000;
    const WheelRailSolution round = solve(setup, state);
    for (const double angle : {-1.0, 0.0, 0.4, 2.5})
        setup.wheel_slices.push_back({angle, {ProfileKind::wheel, S1002{}}});
    state.position.pitch = GENERATE(0.0, 0.3, -1000.0);
    const WheelRailSolution sliced = solve(setup, state);
    REQUIRE(sliced.patches.size() == round.patches.size());
    CHECK_THAT(sliced.z, WithinAbs(round.z, 1e-7));
    for (double Wrench::* of : {&Wrench::Fx, &Wrench::Fy, &Wrench::Mx, &Wrench::Mz})
        CHECK_THAT(sliced.forces.track.*of, WithinRel(round.forces.track.*of, 1e-4));
    CHECK_THAT(sliced.patches[0].solution.pmax, WithinRel(round.patches[0].solution.pmax, 1e-5));
    CHECK_THAT(sliced.patches[0].place.radii.wheel_along, WithinRel(round.patches[0].place.radii.wheel_along, 1e-4));
}

TEST_CASE("The axle over a flat goes down by what its edge leaves") {
    const double depth = 0.8, edge = std::acos((R - depth) / R);
    const WheelRailSetup setup = out_of_round([=](double angle) { return of_flat(angle, depth); }, edge / 30, 3 * edge);
    for (const double share : {0.0, 0.3, -0.5, 0.8, 1.0, 1.7}) {
        const double pitch = share * edge, left = std::max(0.0, edge - std::abs(pitch));
        INFO("pitch " << pitch);
        // The edges are rounded between two slices, by a fifth of the change of the radius there.
        CHECK_THAT(first_contact_height(setup, pitch), WithinAbs(R * (1 - std::cos(left)), 0.014 * depth));
        CHECK_THAT(first_contact_height(setup, pitch + 2 * pi), WithinAbs(first_contact_height(setup, pitch), 1e-9));
    }
    CHECK_THAT(first_contact_height(setup, pi), WithinAbs(0, 1e-9));
}

TEST_CASE("A wheel whose slices cover its flat alone is round elsewhere") {
    const double depth = 0.35, half = 0.06;
    WheelRailSetup setup =
        out_of_round([=](double angle) { return -depth / 2 * (1 + std::cos(pi * angle / half)); }, half / 10, half);
    setup.wheel_spline = GENERATE(SliceSpline::shape_preserving, SliceSpline::cubic, SliceSpline::approximating);
    // The last slice deviates by a micrometre, as in measurements.
    if (GENERATE(true, false))
        for (ProfilePoint& point : std::get<ProfilePoints>(setup.wheel_slices.back().profile.shape).points)
            point.z += 1e-3;
    for (const double pitch : {0.1, 1.0, 3.0, 5.0}) CHECK_THAT(first_contact_height(setup, pitch), WithinAbs(0, 1e-3));
    setup.dx = setup.dy = 0.4;
    WheelRailState state;
    state.position.pitch = 2;
    state.Fz = 60000;
    const HertzContact known = hertz_of_force({R, 300}, setup.bodies.materials().normal_compliance(), 60000);
    CHECK_THAT(solve(setup, state).patches.at(0).solution.pmax, WithinRel(known.pmax, 0.01));
}

TEST_CASE("On its flat a wheel presses over most of its length, and beside it as round") {
    const double depth = 0.3, edge = std::acos((R - depth) / R);
    WheelRailSetup setup = out_of_round([=](double angle) { return of_flat(angle, depth); }, edge / 20, 3 * edge);
    setup.dx = setup.dy = 0.5;
    WheelRailState state;
    state.Fz = 60000;
    const WheelRailSolution on_flat = solve(setup, state);
    REQUIRE(on_flat.converged());
    // The flat rests on the rail with both edges.
    REQUIRE(on_flat.patches.size() == 1);
    const Extent x = on_flat.patches[0].place.regions[0].x;
    CHECK(x.to - x.from > 2 * R * std::sin(edge));
    CHECK_THAT(on_flat.patches[0].place.reference.x, WithinAbs(0, 1e-6));
    state.position.pitch = 1;
    const WheelRailSolution beside = solve(setup, state);
    const HertzContact known = hertz_of_force({R, 300}, setup.bodies.materials().normal_compliance(), 60000);
    CHECK_THAT(beside.patches.at(0).solution.pmax, WithinRel(known.pmax, 0.01));
    // Pressures are highest at the edges, and small between them.
    const Grid& grid = on_flat.patches[0].place.grid;
    const std::vector<double>& pressure = on_flat.patches[0].solution.pressure;
    const auto hardest = std::max_element(pressure.begin(), pressure.end()) - pressure.begin();
    CHECK_THAT(std::abs(grid.x(static_cast<int>(hardest) % grid.nx)), WithinAbs(R * std::sin(edge), 2));
    CHECK(pressure[static_cast<std::size_t>(grid.ny / 2 * grid.nx + grid.nx / 2)] < 0.9 * known.pmax);
    CHECK_THAT(beside.z, WithinRel(known.approach, 0.01));
}

TEST_CASE("Where a wheel is worn to another radius it is Hertz's contact of that radius") {
    const double radius = GENERATE(300.0, 900.0);
    WheelRailSetup setup = out_of_round([=](double angle) { return of_arc(angle, radius); }, 0.004, 0.24);
    setup.model = GENERATE(Model::full, Model::hertz);
    WheelRailState state;
    state.Fz = 60000;
    const WheelRailSolution solution = solve(setup, state);
    const HertzContact known = hertz_of_force({radius, 300}, setup.bodies.materials().normal_compliance(), 60000);
    REQUIRE(solution.converged());
    REQUIRE(solution.patches.size() == 1);
    CHECK_THAT(solution.patches[0].solution.pmax, WithinRel(known.pmax, 0.01));
    CHECK_THAT(solution.patches[0].solution.approach, WithinRel(known.approach, 0.01));
    CHECK_THAT(solution.patches[0].place.radii.wheel_along, WithinRel(radius, 0.01));
}

TEST_CASE("A smooth flat presses as hard as one by ten times as many slices") {
    const double depth = 0.35, half = 0.06;  // rad: 27 mm to both sides
    const auto flat = [=](double angle) {
        return std::abs(angle) < half ? -depth / 2 * (1 + std::cos(pi * angle / half)) : 0;
    };
    const double pitch = GENERATE(0.0, 0.007, 0.03);
    WheelRailState state;
    state.position.pitch = pitch;
    state.Fz = 60000;
    const auto hardest = [&](double step) {
        WheelRailSetup setup = out_of_round(flat, step, 0.12);
        setup.dx = setup.dy = 0.4;
        return solve(setup, state).patches.at(0).solution.pmax;
    };
    CHECK_THAT(hardest(half / 10), WithinRel(hardest(half / 100), 0.02));
}

TEST_CASE("A wheel whose middle is beside its axle rolls up and down, and touches ahead or behind") {
    const double aside = 0.5;  // mm
    const WheelRailSetup setup = out_of_round(
        [=](double angle) {
            return aside * std::cos(angle) + std::sqrt(R * R - aside * aside * std::sin(angle) * std::sin(angle)) - R;
        },
        pi / 90, pi);
    for (const double pitch : {0.0, 0.7, -2.0, 3.0, 40.0}) {
        CHECK_THAT(first_contact_height(setup, pitch), WithinAbs(-aside * std::cos(pitch), 1e-3));
        WheelRailState state;
        state.position.pitch = pitch;
        state.Fz = 60000;
        const WheelRailSolution solution = solve(setup, state);
        REQUIRE(solution.patches.size() == 1);
        CHECK_THAT(solution.patches[0].place.reference.x, WithinAbs(aside * std::sin(pitch), 0.05));
    }
}

TEST_CASE("A left wheel with a flat is a right one in a mirror, to the last bit") {
    WheelRailSetup setup = out_of_round([](double angle) { return of_flat(angle, 0.4); }, 0.01, 0.1);
    setup.friction = WheelRailFriction{};
    setup.dx = setup.dy = 0.5;
    WheelRailState state;
    state.position = {0.7, 0, 0.002, 0.012, 0, 0.02};
    state.velocity = {20000, 15, 3, 0.01, 0.02, -43};
    state.Fz = 60000;
    const WheelRailSolution right = solve(setup, state);
    setup.side = Side::left;
    const WheelRailSolution left = mirrored(solve(setup, mirrored(state)));
    REQUIRE(right.in_contact());
    CHECK(left.forces.track == right.forces.track);
    CHECK(left.patches[0].solution.pressure == right.patches[0].solution.pressure);
}

TEST_CASE("Mistakes in the slices of a wheel are refused by name") {
    const auto refused = [](const std::function<void(WheelRailSetup&)>& spoil, const std::string& sentence) {
        WheelRailSetup setup;
        for (const double angle : {-0.1, 0.0, 0.1}) setup.wheel_slices.push_back({angle, {}});
        spoil(setup);
        CHECK_THROWS_AS(WheelRailContact(setup), InvalidArgument);
        CHECK_THROWS_WITH(WheelRailContact(setup), ContainsSubstring(sentence));
    };
    refused([](auto& setup) { setup.wheel_slices.resize(1); }, "wheel_slices has one slice");
    refused([](auto& setup) { setup.wheel_slices[1].angle = -0.1; },
            "wheel_slices[1].angle is -0.1; it must be larger");
    refused([](auto& setup) { setup.wheel_slices[2].angle = NAN; }, "wheel_slices[2].angle is nan");
    refused([](auto& setup) { setup.wheel_slices[2].angle = 6.25; },
            "wheel_slices[2].angle is 6.25; it must be less than");
    refused([](auto& setup) { setup.wheel_slices[2].angle = 180; }, "wheel_slices[2].angle is 180; it must lie in");
    refused([](auto& setup) { setup.wheel_slices[0].profile = setup.rail; }, "wheel_slices[0].profile.kind is rail");
    refused([](auto& setup) { setup.wheel_slices[1].profile.shape = ProfilePoints{{{0, 0}}}; },
            "wheel_slices[1].profile.points");
    refused([](auto& setup) { setup.wheel_slices[1].profile.shape = ConeProfile{0, -40, 40}; },
            "wheel_slices[1].profile reaches from y = -40");
    refused([](auto& setup) { setup.conformal = Conformal::fem; }, "conformal is fem, but the wheel has slices");
    const WheelRailContact contact{WheelRailSetup{}};
    WheelRailState state;
    state.position.pitch = INFINITY;
    Observer observer;
    CHECK_THROWS_WITH(contact.solve(state, observer), ContainsSubstring("position.pitch is inf"));
}

// Tests contact of layered bodies: limits, and contact conditions of random problems.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

#include "random_layers.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Material steel{82000, 0.28};

Body steel_in_layers() {
    return Body::of(Layers{{{0.3, steel.G, steel.nu}, {1.7, steel.G, steel.nu}}, steel});
}

double largest_difference(const Values& one, const Values& other) {
    double result = 0;
    for (std::size_t i = 0; i < one.size(); ++i) result = std::max(result, std::abs(one[i] - other[i]));
    return result;
}

ContactProblem ball(int n, double size, const Body& upper, const Body& lower) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, size / n, size / n);
    problem.bodies = {upper, lower};
    problem.gap = Paraboloid{100, 60};
    problem.approach = 0.01;
    problem.settings.normal.tolerance = 1e-10;
    return problem;
}

}  // namespace

TEST_CASE("layers of one material are in contact as the half-space is") {
    ContactProblem problem = ball(24, 3, {steel}, {steel});
    problem.friction = FrictionLaw{{0.3}};
    SECTION("a shift") {
        problem.motion = Shift{{1e-3, 5e-4}, 1e-3};
    }
    SECTION("steady rolling, by an element") {
        problem.motion = Rolling{.xi = 1e-3, .eta = 5e-4, .phi = 1e-3};
    }
    SECTION("steady rolling at an angle, by a part of an element") {
        problem.motion = Rolling{.xi = 1e-3, .chi = 0.4, .dq = 0.07};
    }
    SECTION("transient rolling") {
        Rolling rolling{.xi = 1e-3, .dq = 0.2};
        rolling.kind = RollingKind::transient;
        rolling.steps = 3;
        problem.motion = rolling;
    }
    const ContactSolution expected = solve_half_spaces(problem);
    REQUIRE(expected.converged());
    const bool below = GENERATE(true, false), above = GENERATE(true, false);
    if (below) problem.bodies.lower = steel_in_layers();
    if (above) problem.bodies.upper = steel_in_layers();
    const ContactSolution found = solve_layers(problem);
    REQUIRE(found.converged());
    CHECK(largest_difference(found.pressure, expected.pressure) < 1e-7 * expected.pmax);
    CHECK(largest_difference(found.traction_x, expected.traction_x) < 1e-4 * expected.pmax);
    CHECK(largest_difference(found.traction_y, expected.traction_y) < 1e-4 * expected.pmax);
}

// Hertz's line contact: a^2 = 4 F R/(pi E*), pmax = 2 F/(pi a) for the force F per length, with E* = G/(1 - nu).
TEST_CASE("a row of long elements on layers is a line contact, and its ends are no border") {
    constexpr double radius = 100, force = 500;
    ContactProblem problem;
    problem.grid = Grid::of_elements(64, 1, 0.03, 20);
    problem.bodies = {{steel}, steel_in_layers()};
    problem.gap = Paraboloid{.Rx = radius};
    problem.Fn = force * problem.grid.dy;
    const double pi = std::numbers::pi, modulus = steel.G / (1 - steel.nu),
                 a = std::sqrt(4 * force * radius / pi / modulus);
    const ContactSolution solution = solve_layers(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.pmax, WithinRel(2 * force / (pi * a), 5e-3));
    CHECK(solution.elements.border == 0);
    CHECK(solution.warnings.empty());

    problem.grid.dy = 4;  // hardly longer than the contact, so its ends matter
    problem.Fn = force * problem.grid.dy;
    CHECK(solve_layers(problem).elements.border > 0);
}

TEST_CASE("a line contact of layers is refused with the way round it") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(64, 1, 0.03, 20);
    problem.gap = Paraboloid{.Rx = 100};
    problem.Fn = 1e4;
    Ics line;
    line.line_contact = LineContactSpec{100};
    const Body layered = steel_in_layers();
    Body layered_line = layered;
    std::get<Ics>(layered_line.ics).line_contact = line.line_contact;
    for (const Body& lower : {layered, layered_line})
        for (const Body& upper : {Body{steel, line}, layered}) {
            if (lower == layered && upper == layered) continue;
            problem.bodies = {upper, lower};
            CHECK_THROWS_WITH(validate(problem), ContainsSubstring("use one row of long elements, with grid.ny = 1"));
        }
}

TEST_CASE("a ball on a thin layer on a rigid base presses as on a Winkler foundation") {
    const Layers layer{{{0.002, 10, 0.3}}, Material::rigid()};
    const ContactProblem problem = ball(40, 3, {Material::rigid()}, Body::of(layer));
    const ContactSolution solution = solve_layers(problem);
    REQUIRE(solution.converged());
    const double stiffness = 2 * 10 * 0.7 / (0.4 * 0.002);
    const Values h = undeformed_distance(problem);
    for (std::size_t i = 0; i < h.size(); ++i)
        CHECK_THAT(solution.pressure[i], WithinAbs(stiffness * std::max(0.01 - h[i], 0.0), 1e-7 * stiffness * 0.01));
}

TEST_CASE("bodies that change places press alike and rub the other way") {
    const Body rubber = Body::of(Layers{{{0.5, 5, 0.5}}, Material::rigid()});
    const Body coated = Body::of(Layers{{{0.05, 50, 0.2}}, {8, 0.3}});
    ContactProblem problem = ball(20, 3, rubber, coated);
    problem.friction = FrictionLaw{{0.4}};
    problem.motion = Rolling{.xi = 0.02, .dq = 0.1};
    const ContactSolution one = solve_layers(problem);
    REQUIRE(one.converged());
    CHECK(one.evidence.outer);  // they are coupled
    std::swap(problem.bodies.upper, problem.bodies.lower);
    std::get<Rolling>(problem.motion).xi = -0.02;
    const ContactSolution other = solve_layers(problem);
    REQUIRE(other.converged());
    CHECK(largest_difference(one.pressure, other.pressure) < 1e-5 * one.pmax);
    for (std::size_t i = 0; i < one.pressure.size(); ++i)
        CHECK_THAT(other.traction_x[i], WithinAbs(-one.traction_x[i], 1e-4 * one.pmax));
}

TEST_CASE("a thin incompressible layer tends to one that only shears, as fast as it gets thinner") {
    constexpr double flexibility = 2e-5, alone = -4167.20124;  // Fx of friction.layer, test_interfacial_layer.cpp
    const auto [thickness, off] = GENERATE(std::pair(0.02, 15.6), std::pair(0.005, 3.9), std::pair(0.001, 0.79));
    const Layers coated{{{thickness, thickness / flexibility, 0.5}}, steel};
    ContactProblem problem;
    problem.grid = Grid::of_elements(17, 15, 0.65, 0.6);
    problem.bodies = {{steel}, Body::of(coated)};
    problem.gap = Paraboloid{460, 300};
    problem.Fn = 30000;
    problem.friction = FrictionLaw{{0.35}};
    problem.motion = Rolling{.xi = 1.1e-3, .eta = -7e-4, .phi = 1.5e-4, .dq = 0.65};
    problem.settings.tangential.tolerance = problem.settings.outer.tolerance = 1e-7;
    const ContactSolution solution = solve_layers(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(std::abs(solution.forces.Fx - alone), WithinRel(off, 0.05));
    CHECK(solution.elements.adhesion == 117);
}

TEST_CASE("a thin incompressible layer holds the contact that its stiffness asks for") {
    // Beneath a wide contact it hardly yields, and the equations are nearly singular.
    const double thickness = GENERATE(0.3, 0.1, 0.02);
    const Layers layer{{{thickness, 1, 0.5}}, Material::rigid()};
    const ContactProblem problem = ball(40, 3, {Material::rigid()}, Body::of(layer));
    const ContactSolution solution = solve_layers(problem);
    CHECK(solution.converged());
    CHECK(contact_faults(problem, solution, {}, 1e-4).empty());
}

TEST_CASE("random problems of layers meet all contact conditions", "[contact]") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const ContactProblem problem = random_layered_contact(seed, 10);
        const ContactSolution solution = solve_layers(problem);
        INFO("seed " << seed);
        CHECK(solution.converged());
        CHECK(contact_faults(problem, solution, state_before_last(problem, solve_layers), 1e-4) == "");
    }
}

TEST_CASE("layers of one material carry hat functions as the half-space does") {
    Ics bilinear;
    bilinear.load_shape = LoadShape::bilinear;
    ContactProblem problem = ball(20, 3, {steel, bilinear}, {steel, bilinear});
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 1e-3, .dq = GENERATE(0.15, 0.1)};
    const ContactSolution expected = solve_half_spaces(problem);
    const Layers layers{{{0.3, steel.G, steel.nu}, {1.7, steel.G, steel.nu}}, steel};
    problem.bodies = {Body::of(layers, LoadShape::bilinear), Body::of(layers, LoadShape::bilinear)};
    const ContactSolution found = solve_layers(problem);
    REQUIRE(found.converged());
    CHECK(largest_difference(found.pressure, expected.pressure) < 1e-7 * expected.pmax);
    CHECK(largest_difference(found.traction_x, expected.traction_x) < 1e-4 * expected.pmax);
}

TEST_CASE("layers roll against a body that brings a table") {
    ContactProblem problem = ball(20, 3, {steel}, {steel});
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 1e-3, .dq = 0.1};
    const ContactSolution expected = solve_half_spaces(problem);
    const IcTable given = body_table(problem.grid, steel);
    problem.bodies = {{steel, GivenIcs{given, problem.grid.dx, problem.grid.dy}}, steel_in_layers()};
    const ContactInfluence influence =
        make_influence(problem, BodyTable(given), BodyTable(table_of(problem.grid, problem.bodies.lower)));
    Observer observer;
    const ContactSolution found = solve_contact(problem, influence, observer);
    REQUIRE(found.converged());
    CHECK(largest_difference(found.pressure, expected.pressure) < 1e-7 * expected.pmax);
    CHECK(largest_difference(found.traction_x, expected.traction_x) < 1e-3 * expected.pmax);
}

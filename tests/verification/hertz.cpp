// Tests elliptic Hertzian contact (Johnson, Contact Mechanics, section 4.2).
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "contact/contact_cases.hpp"
#include "contactd/solve_contact.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinRel;

TEST_CASE("ellipses agree with Hertz", "[verification]") {
    // Semi-axes a, b and the largest pressure p0 give radii and approach (Johnson (4.26)): with e^2 = 1 - b^2/a^2,
    // 1/(2Rx) = p0 b (K - E)/(E* e^2 a^2), 1/(2Ry) = p0 b ((a/b)^2 E - K)/(E* e^2 a^2), delta = p0 b K/E*.
    const auto [a, b] = GENERATE(std::pair{6.0, 4.0}, std::pair{2.0, 0.5}, std::pair{1.01, 1.0});
    const Material steel{82000, 0.28};
    const double p0 = 1000, modulus = steel.G / (1 - steel.nu);
    const double e = std::sqrt(1 - b * b / (a * a)), K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
    const double common = p0 * b / (modulus * e * e * a * a);
    ContactProblem problem;
    problem.grid = Grid::of_elements(100, 96, 2.2 * a / 100, 2.2 * b / 96);
    problem.bodies = Bodies::of({steel, steel});
    problem.gap = Paraboloid{0.5 / (common * (K - E)), 0.5 / (common * (a * a / (b * b) * E - K))};
    problem.approach = p0 * b * K / modulus;
    const ContactInfluence influence = make_influence(problem, half_space_pair(problem.grid, steel));
    Observer observer;

    const auto solution = solve_contact(problem, influence, observer);

    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fn, WithinRel(2.0 / 3 * std::numbers::pi * a * b * p0, 1e-3));
    CHECK_THAT(solution.pmax, WithinRel(p0, 2e-3));
    CHECK_THAT(solution.area.contact, WithinRel(std::numbers::pi * a * b, 1e-2));
}

TEST_CASE("spheres of different materials agree with Hertz", "[verification]") {
    const MaterialPair bodies{{200, 0.42}, {3000, 0.1}};
    const auto hertz = reference::hertz(bodies, 20, 0.01);
    ContactProblem problem;
    problem.grid = Grid::of_elements(90, 75, 2.4 * hertz.radius / 90, 2.4 * hertz.radius / 75);
    problem.bodies = Bodies::of(bodies);
    problem.gap = Paraboloid{20, 20};
    problem.approach = 0.01;
    IcSpec spec;
    spec.dx = problem.grid.dx;
    spec.dy = problem.grid.dy;
    spec.nx = 90;
    spec.ny = 75;
    spec.material = bodies.upper;
    const IcTable upper = half_space_table(spec);
    spec.material = bodies.lower;
    const ContactInfluence influence = make_influence(problem, pair_of(upper, half_space_table(spec)));
    Observer observer;

    const auto solution = solve_contact(problem, influence, observer);

    CHECK_THAT(solution.forces.Fn, WithinRel(hertz.Fn, 1e-3));
    CHECK_THAT(solution.pmax, WithinRel(hertz.pmax, 2e-3));
}

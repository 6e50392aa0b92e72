// Tests the start of normal contact without an estimate of its pressures.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numeric>

#include "contact/normal/hertz_start.hpp"
#include "contact_cases.hpp"
#include "plain_operator.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Creates an ellipse of 6 x 4 mm in a window 1.1 times its box, under 50 kN.
ContactProblem ellipse(int n) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 13.2 / n, 8.8 / n);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = SemiAxes{6, 4};
    problem.Fn = 50000;
    return problem;
}

/// Gives the gap as an array, from which Hertz's parameters are unknown.
ContactProblem with_array(ContactProblem problem) {
    problem.gap = undeformed_distance(problem);
    return problem;
}

double force_of(const Values& pressure, const Grid& grid) {
    return std::accumulate(pressure.begin(), pressure.end(), 0.0) * grid.element_area();
}

void check_same(const ContactProblem& problem) {
    const ContactSolution solution = solve_half_spaces(problem), expected = solve_half_spaces(with_array(problem));
    REQUIRE(solution.converged());
    REQUIRE(expected.converged());
    CHECK_THAT(solution.forces.Fn, WithinRel(expected.forces.Fn, 1e-6));
    CHECK_THAT(solution.approach, WithinRel(expected.approach, 1e-6));
    for (std::size_t i = 0; i < expected.pressure.size(); ++i)
        CHECK_THAT(solution.pressure[i], WithinAbs(expected.pressure[i], 1e-5 * expected.pmax));
}

}  // namespace

TEST_CASE("normal contact of curved bodies starts from Hertz's pressures", "[normal]") {
    ContactProblem problem = ellipse(50);
    SECTION("under a force") {}
    SECTION("under an approach") {
        problem.Fn.reset();
        problem.approach = 0.0665;
    }
    SECTION("beside the element centres") {
        problem.grid.x0 += 0.1;
        problem.grid.y0 -= 0.03;
    }
    CHECK(products_of(problem) <= 0.7 * products_of(with_array(problem)));
}

TEST_CASE("pressures of another load are no better a start than Hertz's", "[normal]") {
    ContactProblem problem = ellipse(50);
    const int cold = products_of(problem);
    problem.Fn = 45000;
    problem.gap = *paraboloid_of(ellipse(50));
    const ContactSolution last = solve_half_spaces(problem);
    problem.initial.pressure = last.pressure;

    CHECK(solve_half_spaces(problem).evidence.normal.iterations == 0);
    problem.Fn = 50000;
    CHECK(products_of(problem) <= cold + 1);
}

TEST_CASE("the start carries the force", "[normal]") {
    ContactProblem problem = ellipse(30);
    CHECK_THAT(force_of(hertz_start(problem), problem.grid), WithinRel(50000.0, 0.01));
    problem.Fn.reset();
    problem.approach = solve_half_spaces(ellipse(30)).approach;
    CHECK_THAT(force_of(hertz_start(problem), problem.grid), WithinRel(50000.0, 0.01));
}

TEST_CASE("a cylinder starts from the strip under its force per length", "[normal]") {
    ContactProblem problem = ellipse(40);
    const bool along_x = GENERATE(false, true);
    problem.gap = along_x ? Paraboloid{infinity, 300} : Paraboloid{300, infinity};
    const Values pressure = hertz_start(problem);
    CHECK_THAT(force_of(pressure, problem.grid), WithinRel(50000.0, 0.03));
    CHECK(pressure.front() == 0);
    CHECK(pressure[along_x ? at(problem.grid, 0, 20) : at(problem.grid, 20, 0)] > 0);
}

TEST_CASE("there is no start where Hertz has no answer", "[normal]") {
    ContactProblem problem = ellipse(20);
    SECTION("an array") {
        problem.gap = undeformed_distance(problem);
    }
    SECTION("concave or flat") {
        problem.gap = GENERATE(Paraboloid{-10, 10}, Paraboloid{10, -10}, Paraboloid{infinity, -3}, Paraboloid{});
    }
    SECTION("a cylinder's approach") {
        problem.gap = Paraboloid{10, infinity};
        problem.Fn.reset();
        problem.approach = 0.01;
    }
    SECTION("a table of the pair") {
        problem.gap = Paraboloid{10, 10};
        problem.bodies.pair = GivenIcs{};
    }
    SECTION("nothing presses") {
        problem.gap = Paraboloid{10, 10};
        problem.Fn.reset();
        problem.approach = GENERATE(0.0, -0.1);
    }
    SECTION("beside the grid") {
        problem.grid.x0 += 20;
    }
    CHECK(hertz_start(problem).empty());
}

TEST_CASE("a poor start does not change the answer", "[normal]") {
    ContactProblem problem = ellipse(24);
    SECTION("the grid cuts the contact off") {
        problem.grid = Grid::of_elements(24, 24, 0.3, 0.1);
    }
    SECTION("half of the contact lies beyond the grid") {
        problem.grid.x0 += 6;
    }
    SECTION("few elements") {
        problem.grid = Grid::of_elements(5, 4, 3, 3);
    }
    SECTION("a cylinder that ends with the grid") {
        problem.gap = Paraboloid{300, infinity};
    }
    SECTION("dissimilar bodies") {
        problem.bodies.lower.material = {8000, 0.1};
        problem.friction = FrictionLaw{{0.5}};
        problem.motion = Shift{.rigid_shift = {0.02, 0}};
    }
    check_same(problem);
}

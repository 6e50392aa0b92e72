// Tests the error estimates in solutions for elements and steps that are too large.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "closed_forms/hertz.hpp"
#include "contact/rolling/rolling.hpp"
#include "contact_cases.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;
const Material steel{82000, 0.28};

/// Uses n x n elements over 1.1 times the box of the ellipse.
ContactProblem rolling_ellipse(double a, double b, int n, const Rolling& rolling) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 2.2 * a / n, 2.2 * b / n);
    problem.bodies = Bodies::of({steel, steel});
    problem.gap = SemiAxes{a, b};
    problem.Fn = 50000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = rolling;
    return problem;
}

/// Creates the sphere of the Cattaneo problem, with a contact of radius 1 mm on elements of this size.
ContactProblem sphere(int n, double element) {
    ContactProblem problem = cattaneo_problem(n);
    problem.friction.reset();
    problem.grid = Grid::of_elements(n, n, element, element);
    return problem;
}

bool says(const ContactSolution& solution, const std::string& sentence) {
    for (const std::string& warning : solution.warnings)
        if (warning.find(sentence) != std::string::npos) return true;
    return false;
}

double relative_difference(double value, double truth) {
    return std::abs(value / truth - 1);
}

}  // namespace

TEST_CASE("a step that is left out is the size of an element along the rolling direction", "[discretisation]") {
    const Grid grid = Grid::of_elements(4, 4, 0.5, 0.05);
    CHECK(step_length(Rolling{.chi = 0}, grid) == 0.5);
    CHECK(step_length(Rolling{.chi = pi}, grid) == 0.5);
    CHECK(step_length(Rolling{.chi = pi / 2}, grid) == 0.05);
    CHECK(step_length(Rolling{.chi = -pi / 2}, grid) == 0.05);
    const double oblique = step_length(Rolling{.chi = 0.3}, grid);
    CHECK(oblique > 0.05);
    CHECK(oblique < 0.5);
    CHECK_THAT(step_length(Rolling{.chi = pi / 2 + 0.3}, Grid::of_elements(4, 4, 0.05, 0.5)),
               WithinRel(oblique, 1e-12));
    const double chi = GENERATE(0.3, pi / 4, 2.0, -1.4);
    CHECK_THAT(step_length(Rolling{.chi = chi}, Grid::of_elements(4, 4, 0.5, 0.5)), WithinRel(0.5, 1e-12));
    CHECK(step_length(Rolling{.chi = chi, .dq = 0.7}, grid) == 0.7);
}

TEST_CASE("a slender contact and its motion rotated by a right angle have the same forces", "[discretisation]") {
    const auto along = solve_half_spaces(rolling_ellipse(6, 0.6, 20, Rolling{.xi = 1e-3, .eta = 4e-4, .phi = 1e-3}));
    const auto rotated =
        solve_half_spaces(rolling_ellipse(0.6, 6, 20, Rolling{.xi = -4e-4, .eta = 1e-3, .phi = 1e-3, .chi = pi / 2}));
    REQUIRE(along.converged());
    REQUIRE(rotated.converged());
    CHECK_THAT(rotated.forces.Fy, WithinRel(along.forces.Fx, 1e-5));
    CHECK_THAT(rotated.forces.Fx, WithinRel(-along.forces.Fy, 1e-5));
    CHECK_THAT(rotated.forces.Mz, WithinRel(along.forces.Mz, 1e-4));
    CHECK_THAT(*rotated.frictional_power, WithinRel(*along.frictional_power, 1e-4));
    CHECK(rotated.elements.slip == along.elements.slip);
}

TEST_CASE("a step far above the elements or the contact is warned of", "[discretisation]") {
    const RollingKind kind = GENERATE(RollingKind::steady, RollingKind::transient);
    const auto rolled = [&](int n, double dq, double chi = 0) {
        return solve_half_spaces(rolling_ellipse(6, 4, n, Rolling{.xi = 1e-3, .chi = chi, .dq = dq, .kind = kind}));
    };
    const double element = 13.2 / 44;  // 40 across
    CHECK(rolled(44, 0).warnings.empty());
    CHECK(rolled(44, 2.9 * element).warnings.empty());
    CHECK(says(rolled(44, 3 * element), "3 elements and 0.075 of the contact's length"));
    CHECK(says(rolled(22, 1.25), "0.104 of the contact's length"));  // two elements
    CHECK(says(rolled(22, 20), "friction.rolling.dq is 20 mm"));
    CHECK(rolled(44, 2.9 * 8.8 / 44, pi / 2).warnings.empty());
    CHECK(says(rolled(44, 3 * 8.8 / 44, pi / 2), "3 elements"));
    const auto coarse = rolled(10, 0);  // the error of one element, which is a tenth of the contact
    CHECK_FALSE(says(coarse, "friction.rolling.dq"));
}

TEST_CASE("the estimated error of rolling is that of small creepages", "[discretisation]") {
    const auto force = [](int n, double dq) {
        ContactProblem problem = rolling_ellipse(5, 5, n, Rolling{.xi = 1e-6, .dq = dq});
        problem.friction->mu = {1000};
        const auto solution = solve_half_spaces(problem);
        REQUIRE(solution.converged());
        return std::pair(solution.forces.Fx, *solution.evidence.discretisation->rolling_error);
    };
    const double limit = 2 * force(96, 0).first - force(48, 0).first;
    const int n = GENERATE(11, 16, 27);
    const double steps = GENERATE(1.0, 3.0, 10.0);
    const auto [Fx, estimate] = force(n, steps * 11.0 / n);
    const double error = relative_difference(Fx, limit);
    CAPTURE(n, steps, error, estimate);
    CHECK(error < 1.3 * estimate);
    if (steps > 1) CHECK(error > 0.25 * estimate);  // the error of the elements alone may vanish by accident
}

TEST_CASE("errors of a paraboloid on half-spaces are those against Hertz", "[discretisation]") {
    const auto exact = hertz_of_approach({50, 50}, (1 - 0.42) / 200, 0.02);
    ContactProblem problem = sphere(9, 0.4);
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.evidence.discretisation);
    CHECK(solution.evidence.discretisation->source == ErrorSource::hertz);
    CHECK(solution.evidence.discretisation->elements_across == 5);
    CHECK_THAT(solution.evidence.discretisation->force_error,
               WithinAbs(relative_difference(solution.forces.Fn, exact.Fn), 1e-9));
    CHECK_THAT(solution.evidence.discretisation->pmax_error,
               WithinAbs(relative_difference(solution.pmax, exact.pmax), 1e-9));
    CHECK_FALSE(solution.evidence.discretisation->rolling_error);

    problem.approach.reset();
    problem.Fn = exact.Fn;  // the approach now has the error, 2/3 of that of the force
    const auto under_force = solve_half_spaces(problem);
    const double sinks_in = std::pow(under_force.approach / 0.02, 1.5);
    CHECK_THAT(under_force.evidence.discretisation->force_error, WithinAbs(std::abs(1 / sinks_in - 1), 1e-9));
    CHECK_THAT(under_force.evidence.discretisation->pmax_error,
               WithinAbs(relative_difference(under_force.pmax, exact.pmax), 1e-9));
}

TEST_CASE("where Hertz does not hold errors are estimated from the elements across", "[discretisation]") {
    const int across = GENERATE(4, 6, 10, 20);
    ContactProblem problem = sphere(2 * (across / 2) + 5, 2.0 / across);
    const auto known = solve_half_spaces(problem);
    problem.gap = undeformed_distance(problem);
    const auto estimated = solve_half_spaces(problem);
    REQUIRE(known.evidence.discretisation->source == ErrorSource::hertz);
    REQUIRE(estimated.evidence.discretisation->source == ErrorSource::estimate);
    CHECK(estimated.evidence.discretisation->elements_across == known.evidence.discretisation->elements_across);
    CAPTURE(known.evidence.discretisation->force_error, estimated.evidence.discretisation->force_error);
    CAPTURE(known.evidence.discretisation->pmax_error, estimated.evidence.discretisation->pmax_error);
    CHECK(known.evidence.discretisation->force_error < 1.5 * estimated.evidence.discretisation->force_error);
    CHECK(known.evidence.discretisation->pmax_error < 1.5 * estimated.evidence.discretisation->pmax_error);
    CHECK(estimated.evidence.discretisation->force_error < 0.6 / across);
}

TEST_CASE("errors are numbers however little the bodies overlap", "[discretisation]") {
    ContactProblem problem = sphere(9, 0.4);
    problem.approach = GENERATE(1e-6, 1e-12, 1e-100);
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.elements.contact == 1);
    CHECK(std::isfinite(solution.evidence.discretisation->force_error));
    CHECK(std::isfinite(solution.evidence.discretisation->pmax_error));
    CHECK(solution.evidence.discretisation->force_error >= 1);
}

TEST_CASE("contacts that Hertz does not describe are not compared with him", "[discretisation]") {
    ContactProblem problem = cattaneo_problem(16);
    CHECK(solve_half_spaces(problem).evidence.discretisation->source == ErrorSource::hertz);
    SECTION("coupled with friction") {
        problem.bodies.lower.material = {400, 0.3};
    }
    SECTION("cut off at the border") {
        problem.approach = 0.05;
    }
    SECTION("a block") {
        Ics block;
        block.source = IcSource::fem;
        block.body = BodyShape::block;
        problem.bodies = Bodies::of({steel, steel}, block);
    }
    SECTION("coefficients of the request") {
        problem.bodies.pair = GivenIcs{pair_table(problem), problem.grid.dx, problem.grid.dy};
    }
    SECTION("a flat direction") {
        problem.gap = Paraboloid{.Rx = 50};
    }
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.evidence.discretisation);
    CHECK(solution.evidence.discretisation->source == ErrorSource::estimate);
}

TEST_CASE("a contact of fewer than eight elements across is warned of", "[discretisation]") {
    CHECK(solve_half_spaces(sphere(11, 2.0 / 8)).warnings.empty());
    const auto coarse = solve_half_spaces(sphere(11, 2.0 / 6));
    CHECK(coarse.evidence.discretisation->elements_across == 7);
    REQUIRE(coarse.warnings.size() == 1);
    CHECK(says(coarse, "7 elements across, fewer than 8"));
    ContactProblem four = sphere(40, 2.4);  // Uses 40 x 40 elements of 2.4 mm, where 2.4 mm is the whole width.
    four.approach.reset();
    four.Fn = 9.2;
    const auto under_force = solve_half_spaces(four);
    CHECK(under_force.elements.contact == 4);
    CHECK(says(under_force, "2 elements across"));
    CHECK(under_force.evidence.discretisation->force_error > 0.4);
    SECTION("in one direction only") {
        ContactProblem problem = sphere(11, 0.2);
        problem.grid = Grid::of_elements(11, 31, 2.0 / 6, 0.1);
        CHECK(says(solve_half_spaces(problem), "7 elements across"));
    }
    SECTION("each of several") {
        ContactProblem problem = sphere(40, 0.1);
        Values h(problem.grid.size());
        for (int iy = 0; iy < 40; ++iy)
            for (int ix = 0; ix < 40; ++ix)
                h[at(problem.grid, ix, iy)] = 0.02 + 0.02 * std::cos(2 * pi * (ix + 0.5) / 10);  // four ridges
        problem.gap = h;
        problem.approach = 0.01;
        CHECK(says(solve_half_spaces(problem), "elements across"));
    }
}

TEST_CASE("a line contact is not asked for elements along it", "[discretisation]") {
    ContactProblem problem = sphere(1, 1);
    const int rows = GENERATE(1, 3);
    problem.gap = Paraboloid{.Rx = 50};
    problem.grid = Grid::of_elements(40, rows, 0.06, 60.0 / rows);
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.elements.contact == rows * solution.evidence.discretisation->elements_across);
    CHECK_FALSE(says(solution, "elements across"));
    problem.grid = Grid::of_elements(8, rows, 0.4, 60.0 / rows);
    CHECK(says(solve_half_spaces(problem), "elements across"));
}

TEST_CASE("a grid without an element in the contact says so", "[discretisation]") {
    ContactProblem problem = sphere(40, 2.4);
    const auto between = solve_half_spaces(problem);
    CHECK(between.elements.contact == 0);
    CHECK_FALSE(between.evidence.discretisation);
    CHECK(says(between, "narrower than the elements"));
    problem.grid = {40, 40, 0.06, 0.06, 3, -1.2};
    CHECK(says(solve_half_spaces(problem), "outside the potential contact area"));
    problem.approach = -0.001;
    CHECK(solve_half_spaces(problem).warnings.empty());
    problem.approach = 0;
    CHECK(solve_half_spaces(problem).warnings.empty());
}

TEST_CASE("simplified models have no elements that err", "[discretisation]") {
    ContactProblem problem = rolling_ellipse(6, 4, 5, Rolling{.xi = 1e-3, .dq = 20});
    problem.grid = Grid::of_elements(7, 7, 3, 2);
    problem.model = GENERATE(Model::hertz, Model::fastsim);
    Observer observer;
    const auto solution = solve_contact(problem, {}, observer);
    CHECK_FALSE(solution.evidence.discretisation);
    CHECK(solution.warnings.empty());
}

TEST_CASE("a rough surface is warned of where most of its contacts are an element, however large one is",
          "[discretisation]") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(40, 40, 0.1, 0.1);
    problem.bodies = Bodies::of({steel, steel});
    problem.approach = 0.01;
    std::vector<double> gap = sampled(Paraboloid{50, 50}, problem.grid);
    const int peaks = GENERATE(0, 8, 12);
    for (int i = 0; i < peaks; ++i)
        gap[static_cast<std::size_t>(i < 6 ? 40 + 3 + 6 * i : 38 * 40 + 3 + 6 * (i - 6))] = 0;
    problem.gap = gap;
    const ContactSolution solution = solve_half_spaces(problem);
    CHECK(says(solution, "The gap produces 13 separate contacts, most of them with at most 1 element.") ==
          (peaks == 12));
    CHECK(says(solution, "separate contacts") == (peaks == 12));
}

TEST_CASE("spin is evaluated ahead of the element centres by its offset", "[discretisation]") {
    const Rolling motion{
        .xi = 1e-3, .eta = -5e-4, .phi = 3e-4, .chi = GENERATE(0.0, pi / 2, 0.7), .spin_offset = 1.0 / 6};
    ContactProblem problem = rolling_ellipse(6, 4, 20, motion);
    const auto solve = [&](const Rolling& rolling) {
        problem.motion = rolling;
        const auto solution = solve_half_spaces(problem);
        REQUIRE(solution.converged());
        return solution;
    };
    const auto ahead_of_centres = solve(motion);
    Rolling same = motion;
    same.spin_offset = 0;
    const double ahead = step_length(motion, problem.grid) / 6;
    same.xi -= same.phi * ahead * std::sin(motion.chi);
    same.eta += same.phi * ahead * std::cos(motion.chi);
    const auto shifted = solve(same);
    CHECK_THAT(shifted.forces.Fx, WithinAbs(ahead_of_centres.forces.Fx, 1e-2));
    CHECK_THAT(shifted.forces.Fy, WithinAbs(ahead_of_centres.forces.Fy, 1e-2));
    CHECK_THAT(shifted.forces.Mz, WithinAbs(ahead_of_centres.forces.Mz, 5e-2));
    same = motion;
    same.spin_offset = 0;
    CHECK(std::abs(solve(same).forces.Fy - ahead_of_centres.forces.Fy) > 2);
}

TEST_CASE("spin evaluated ahead or at the centres has one limit, to which ahead is nearer", "[discretisation]") {
    const auto force = [](int n, double offset) {
        const auto solution = solve_half_spaces(rolling_ellipse(5, 5, n, Rolling{.phi = 7e-4, .spin_offset = offset}));
        REQUIRE(solution.converged());
        return solution.forces.Fy / (0.3 * 50000);
    };
    const auto limit = [&](double offset) { return 2 * force(80, offset) - force(40, offset); };
    const double ahead = limit(1.0 / 6), at_centres = limit(0);
    CHECK_THAT(ahead, WithinAbs(at_centres, 2e-3));
    CHECK(std::abs(force(25, 1.0 / 6) - ahead) < 0.6 * std::abs(force(25, 0) - ahead));
}

TEST_CASE("a rotation of a shift is about the element centres whatever rolling does", "[discretisation]") {
    const Grid grid = Grid::of_elements(3, 2, 1, 1);
    const RigidSlip rotated = rigid_slip(grid, Shift{.rigid_shift = {.x = 0.5}, .rotation = 0.1});
    CHECK_THAT(rotated.x[0], WithinAbs(0.5 - 0.1 * grid.y(0), 1e-15));
    CHECK_THAT(rotated.y[0], WithinAbs(0.1 * grid.x(0), 1e-15));
}

TEST_CASE("an offset of spin outside of a step is refused", "[discretisation]") {
    const double offset = GENERATE(-0.1, 1.5, std::nan(""));
    ContactProblem problem = rolling_ellipse(6, 4, 10, Rolling{.spin_offset = offset});
    try {
        validate(problem);
        FAIL("not refused");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "friction.rolling.spin_offset");
    }
}

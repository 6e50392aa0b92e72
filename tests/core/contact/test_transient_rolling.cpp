// Tests rolling step by step in time, as contact problems.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contact/support/entering_particles.hpp"
#include "contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Creates a sphere on a plane, about eleven elements across the contact.
ContactProblem rolling_sphere(const Rolling& rolling) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(14, 12, 2.4 / 14, 2.4 / 12);
    problem.bodies = {{1000, 0.28}, {1000, 0.28}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    problem.settings.tangential.tolerance = 1e-8;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = rolling;
    return problem;
}

Rolling transient(double xi, double eta, double phi, int steps) {
    return {.xi = xi, .eta = eta, .phi = phi, .chi = 0.3, .dq = 0.15, .kind = RollingKind::transient, .steps = steps};
}

}  // namespace

TEST_CASE("transient rolling from rest reaches the steady state", "[rolling]") {
    Rolling rolling = transient(0.002, 0.001, 0.001, 80);
    const ContactSolution step = solve_half_spaces(rolling_sphere(rolling));
    rolling.kind = RollingKind::steady;
    const ContactSolution steady = solve_half_spaces(rolling_sphere(rolling));

    REQUIRE(step.converged());
    REQUIRE(steady.converged());
    const double unit = 0.3 * steady.pmax;
    for (std::size_t i = 0; i < step.traction_x.size(); ++i) {
        CHECK_THAT(step.traction_x[i], WithinAbs(steady.traction_x[i], 1e-4 * unit));
        CHECK_THAT(step.traction_y[i], WithinAbs(steady.traction_y[i], 1e-4 * unit));
    }
    CHECK_THAT(*step.frictional_power, WithinRel(*steady.frictional_power, 1e-4));
}

TEST_CASE("the first transient step from rest is a shift", "[rolling]") {
    const Rolling rolling = transient(0.004, 0.001, 0, 1);
    ContactProblem problem = rolling_sphere(rolling);
    const ContactSolution step = solve_half_spaces(problem);
    problem.motion = Shift{.rigid_shift = {rolling.dq * rolling.xi, rolling.dq * rolling.eta}};
    const ContactSolution shift = solve_half_spaces(problem);

    CHECK(step.elements.slip > 0);
    CHECK(step.traction_x == shift.traction_x);
    CHECK(step.traction_y == shift.traction_y);
}

TEST_CASE("friction loses no less than nothing, steady or step by step", "[rolling]") {
    const double size = GENERATE(1e-5, 1e-3, 1e-2);
    Rolling rolling = transient(size, -size, 2 * size, 2);
    CHECK(*solve_half_spaces(rolling_sphere(rolling)).frictional_power >= 0);
    rolling.kind = RollingKind::steady;
    CHECK(*solve_half_spaces(rolling_sphere(rolling)).frictional_power >= 0);
}

TEST_CASE("in full slip friction loses the creepage times its whole force", "[rolling]") {
    Rolling rolling = transient(0.6, -0.8, 0, 1);
    rolling.kind = RollingKind::steady;
    rolling.velocity = 7;
    const ContactSolution solution = solve_half_spaces(rolling_sphere(rolling));
    CHECK(solution.elements.adhesion == 0);
    CHECK_THAT(*solution.frictional_power, WithinRel(7 * 0.3 * solution.forces.Fn, 1e-2));
}

TEST_CASE("a step starts from the one before, which the problem states anyway", "[rolling]") {
    ContactProblem problem = rolling_sphere(transient(0.002, 0.001, 0.001, 20));
    const ContactSolution last = solve_half_spaces(problem);
    problem.previous = {last.pressure, last.traction_x, last.traction_y};
    problem.motion = transient(0.0021, 0.001, 0.001, 1);
    const ContactSolution step = solve_half_spaces(problem);
    problem.initial.pressure = last.pressure;
    problem.initial.traction_x = last.traction_x;
    problem.initial.traction_y = last.traction_y;
    const ContactSolution reported = solve_half_spaces(problem);

    CHECK(step.evidence.normal.iterations == 0);
    CHECK(step.evidence.tangential->iterations == reported.evidence.tangential->iterations);
    CHECK(step.traction_x == reported.traction_x);
    CHECK(step.traction_y == reported.traction_y);
}

TEST_CASE("the steps of one problem are those of many", "[rolling]") {
    ContactProblem problem = rolling_sphere(transient(0.002, -0.001, 0.002, 6));
    const ContactSolution march = solve_half_spaces(problem);
    problem.motion = transient(0.002, -0.001, 0.002, 1);
    int iterations = 0;
    ContactSolution step;
    for (int i = 0; i < 6; ++i) {
        step = solve_half_spaces(problem);
        iterations += step.evidence.tangential->iterations;
        problem.previous = {step.pressure, step.traction_x, step.traction_y};
    }
    CHECK(march.evidence.tangential->iterations < iterations);  // start from an extrapolation of the last two
    for (std::size_t i = 0; i < step.traction_x.size(); ++i) {
        CHECK_THAT(march.traction_x[i], WithinAbs(step.traction_x[i], 1e-6 * step.pmax));
        CHECK_THAT(march.traction_y[i], WithinAbs(step.traction_y[i], 1e-6 * step.pmax));
    }
}

TEST_CASE("particles that enter during a step are known by how far they have come", "[rolling]") {
    const Grid grid = Grid::of_elements(5, 2, 1, 1);  // elements of 1 x 1
    const std::vector<double> pressure{0, 1, 1, 1, 0, 1, 1, 0, 1, 1};
    CHECK(entering_particles(grid, pressure, {1, 0}).empty());
    CHECK(entering_particles(grid, std::vector<double>(10), {4, 0}).empty());
    const EnteringParticles right = entering_particles(grid, pressure, {2.5, 0});
    CHECK(right.part == std::vector<double>{1, 1, 0.8, 0.4, 1, 0.8, 0.4, 1, 0.8, 0.4});
    CHECK(right.from[2] == 4);
    CHECK(right.from[6] == 7);
    CHECK(right.from[9] == 9);  // it comes from beyond the grid
    const EnteringParticles left = entering_particles(grid, pressure, {-2, 0});
    CHECK(left.part == std::vector<double>{1, 0.5, 1, 1, 1, 0.5, 1, 1, 0.5, 1});
    CHECK(left.from[8] == 7);
    const EnteringParticles up = entering_particles(grid, pressure, {0, 2});
    CHECK(up.part[2] == 0.5);
    CHECK(up.from[2] == 7);
    CHECK(up.part[1] == 1);
}

TEST_CASE("a first step longer than an element has the division that its particles ask for", "[rolling]") {
    // The CONTACT program printed this result, which treats such particles in the same way: 466 elements adhere.
    ContactProblem problem;
    problem.grid = Grid::of_elements(41, 41, 0.2, 0.2);
    problem.bodies = Bodies::of({{1, 0.28}, {1, 0.28}});
    problem.gap = Paraboloid{1 / 0.005926, 1 / 0.005926};
    problem.Fn = 0.4705;
    problem.friction = FrictionLaw{{0.4013}, {}};
    Rolling rolling;
    rolling.kind = RollingKind::transient;
    rolling.dq = 0.4;
    rolling.velocity = 1000;
    rolling.force.Fx = -0.657 * 0.4013 * 0.4705;
    problem.motion = rolling;
    const ContactSolution solution = solve_half_spaces(problem);
    CHECK(solution.converged());
    CHECK_THAT(std::get<Rolling>(*solution.motion).xi, WithinRel(0.045, 1e-4));
    CHECK(solution.elements.adhesion == 466);
    CHECK(solution.elements.slip == 507);
}

TEST_CASE("steps of several elements end nearer to steady rolling by elements than a steady step as long",
          "[rolling]") {
    Rolling rolling = transient(0.002, 0.001, 0.001, 40);
    rolling.chi = 0;
    rolling.dq = 3 * rolling_sphere(rolling).grid.dx;
    const auto force = [](const Rolling& motion) { return solve_half_spaces(rolling_sphere(motion)).forces.Fx; };
    const double march = force(rolling);
    rolling.kind = RollingKind::steady;
    const double as_long = force(rolling);
    rolling.dq = 0;
    CHECK(std::abs(march - force(rolling)) < 0.7 * std::abs(as_long - force(rolling)));
}

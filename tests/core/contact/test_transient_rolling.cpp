// Rolling step by step in time, as contact problems.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// A sphere on a plane, about eleven elements across the contact.
ContactProblem rolling_sphere(const Rolling& rolling) {
    ContactProblem problem;
    problem.grid = Grid::centred(14, 12, 2.4 / 14, 2.4 / 12);
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
    CHECK(march.evidence.tangential->iterations < iterations);  // they start where the last two lead to
    for (std::size_t i = 0; i < step.traction_x.size(); ++i) {
        CHECK_THAT(march.traction_x[i], WithinAbs(step.traction_x[i], 1e-6 * step.pmax));
        CHECK_THAT(march.traction_y[i], WithinAbs(step.traction_y[i], 1e-6 * step.pmax));
    }
}

// Tests TangCG, the paper's solver, on problems of Newton's method, by `settings.tangential.solver`.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact_cases.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

ContactProblem sliding_sphere(const Motion& motion) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(30, 30, 0.08, 0.08);
    problem.bodies = {{1000, 0.28}, {1000, 0.28}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    problem.settings.tangential.tolerance = 1e-8;
    problem.settings.outer.tolerance = 1e-8;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = motion;
    return problem;
}

/// Solves by both and compares; returns the result of TangCG.
ContactSolution same_by_both(ContactProblem problem) {
    const ContactSolution newton = solve_half_spaces(problem);
    problem.settings.tangential_solver = TangentialSolver::tangcg;
    ContactSolution tangcg = solve_half_spaces(problem);
    REQUIRE(newton.converged());
    REQUIRE(tangcg.converged());
    CHECK(newton.evidence.tangential_solver == TangentialSolver::newton);
    CHECK(tangcg.evidence.tangential_solver == TangentialSolver::tangcg);
    CHECK(tangcg.evidence.tangential->residual <= problem.settings.tangential.tolerance);
    const double unit = 0.3 * newton.pmax;
    for (std::size_t i = 0; i < newton.traction_x.size(); ++i) {
        CHECK_THAT(tangcg.traction_x[i], WithinAbs(newton.traction_x[i], 1e-5 * unit));
        CHECK_THAT(tangcg.traction_y[i], WithinAbs(newton.traction_y[i], 1e-5 * unit));
    }
    return tangcg;
}

}  // namespace

TEST_CASE("TangCG and Newton's method find the same tractions of a shift", "[tangential]") {
    const ContactSolution found = same_by_both(sliding_sphere(Shift{.rigid_shift = {0.003, 0.0004}, .rotation = 1e-4}));
    CHECK(found.elements.adhesion > 0);
    CHECK(found.elements.slip > 0);
}

TEST_CASE("TangCG and Newton's method find the same tractions of transient rolling", "[tangential]") {
    same_by_both(sliding_sphere(
        Rolling{.xi = 0.004, .eta = 0.001, .phi = 0.001, .dq = 0.1, .kind = RollingKind::transient, .steps = 3}));
}

TEST_CASE("TangCG finds the shift that a force takes", "[tangential]") {
    ContactProblem problem = sliding_sphere(Shift{.rigid_shift = {0.008, 0}});
    const double Fx = 0.6 * solve_half_spaces(problem).forces.Fx;
    problem.motion = Shift{.force = {.Fx = Fx}};
    CHECK_THAT(same_by_both(problem).forces.Fx, WithinRel(Fx, 1e-6));
}

TEST_CASE("TangCG starts where Newton's method does: from a good estimate, else from a coarser grid", "[tangential]") {
    ContactProblem problem = sliding_sphere(Shift{.rigid_shift = {0.003, 0.0004}});
    problem.grid = Grid::of_elements(66, 64, 0.04, 0.04);
    problem.settings.tangential_solver = TangentialSolver::tangcg;
    const ContactSolution cold = solve_half_spaces(problem);
    REQUIRE(cold.converged());
    REQUIRE(cold.elements.contact > 1000);
    const auto from = [&](double factor) {
        problem.initial.traction_x = cold.traction_x;
        problem.initial.traction_y = cold.traction_y;
        for (auto* values : {&problem.initial.traction_x, &problem.initial.traction_y})
            for (double& value : *values) value *= factor;
        return solve_half_spaces(problem);
    };
    const auto iterations = [](const ContactSolution& solution) { return solution.evidence.tangential->iterations; };
    CHECK(iterations(from(1)) < iterations(cold) / 2);
    const ContactSolution after_bad = from(-1);
    CHECK(iterations(after_bad) == iterations(cold));
    CHECK(after_bad.traction_x == cold.traction_x);
    CHECK(after_bad.traction_y == cold.traction_y);
}

TEST_CASE("TangCG is refused where operators are not symmetric", "[tangential]") {
    ContactProblem problem = sliding_sphere(Rolling{.xi = 0.002});
    problem.settings.tangential_solver = TangentialSolver::tangcg;
    try {
        validate(problem);
        FAIL("It was accepted.");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "settings.tangential.solver");
    }
    problem.friction.reset();
    CHECK_NOTHROW(validate(problem));
}

TEST_CASE("Without friction no solver has found tractions", "[tangential]") {
    ContactProblem problem = sliding_sphere(Shift{});
    problem.friction.reset();
    CHECK_FALSE(solve_half_spaces(problem).evidence.tangential_solver);
}

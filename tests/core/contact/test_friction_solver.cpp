// Tests Newton's method on the friction law, and the data that it keeps between solves.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>

#include "contact/friction/friction_solver.hpp"
#include "contact/newton/friction_newton.hpp"
#include "rolling_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

struct SmallRolling : RollingCase {
    SmallRolling() : RollingCase(Grid::of_elements(20, 18, 0.1, 0.1), {1000, 0.28}, 3, 0.3, 0.1) {
        set(0.001, -5e-4, 1e-3);
    }

    FrictionBodies bodies_of(bool rolls) const {
        return {influence, rolls ? &increment : nullptr, grid, step_x, step_y};
    }
    Field rigid(double factor = 1) const {
        const RigidSlip slip = rigid_slip(grid, rolling, dq);
        Field field;
        field.x = slip.x;
        field.y = slip.y;
        for (auto* values : {&field.x, &field.y})
            for (double& value : *values) value *= factor;
        return field;
    }
};

Field tractions_of(const RollingSolution& solution) {
    Field field;
    field.x = solution.traction_x;
    field.y = solution.traction_y;
    return field;
}

FrictionTask task_of(std::span<const double> bound, const Field& rigid, const Field& estimate) {
    return {bound, rigid, {}, Pair::Zero(), estimate, {1e-6, 200}};
}

}  // namespace

TEST_CASE("Newton's method gives the tractions of conjugate gradients to shifts", "[newton]") {
    const SmallRolling problem;
    const Field rigid = problem.rigid(30), none(problem.grid.size());
    Observer observer;
    FrictionSolver solver(problem.bodies_of(false));
    const FrictionSolution newton = solver.solve(task_of(problem.bound, rigid, none), observer);
    const TangentialSolution gradients =
        solve_tangential(problem.influence, problem.bound, rigid.x, rigid.y, {1e-8, 200}, {}, {}, observer);
    REQUIRE(newton.evidence.converged);
    REQUIRE(gradients.evidence.converged);
    CHECK(newton.element_division == gradients.element_division);
    for (std::size_t i = 0; i < newton.traction_x.size(); ++i) {
        CHECK_THAT(newton.traction_x[i], WithinAbs(gradients.traction_x[i], 1e-5 * 3));
        CHECK_THAT(newton.traction_y[i], WithinAbs(gradients.traction_y[i], 1e-5 * 3));
    }
}

// If earlier steps suffice, the last tractions and their slip are combinations that need no product.
TEST_CASE("the slip that a solve ends with is that of its tractions to the tolerance", "[newton]") {
    const SmallRolling problem;
    const bool rolls = GENERATE(true, false);
    Observer observer;
    Field last(problem.grid.size());
    int without_product = 0;
    for (int step = 0; step < 20; ++step) {
        const Field rigid = problem.rigid((rolls ? 1 : 30) * (1 + 0.05 * step));
        FrictionSolver solver(problem.bodies_of(rolls));
        const FrictionSolution found = solver.solve(task_of(problem.bound, rigid, last), observer);
        REQUIRE(found.evidence.converged);
        last = tractions_of(found);
        Field u(problem.grid.size());
        if (rolls)
            problem.increment.tangential(last.x, last.y, u.x, u.y);
        else
            problem.influence.tangential(last.x, last.y, u.x, u.y);
        double squares = 0, of_rigid = 0;
        for (std::size_t i = 0; i < u.x.size(); ++i) {
            if (!(problem.bound[i] > 0)) continue;
            squares += std::pow(rigid.x[i] + u.x[i] - found.slip_x[i], 2);
            squares += std::pow(rigid.y[i] + u.y[i] - found.slip_y[i], 2);
            of_rigid += rigid.x[i] * rigid.x[i] + rigid.y[i] * rigid.y[i];
        }
        const double off = std::sqrt(squares / of_rigid);
        CHECK(off <= 1e-6);
        without_product += off > 1e-12;
    }
    CHECK(without_product > 0);
}

TEST_CASE("what solves have learnt saves iterations where bounds go on to change as they did", "[newton]") {
    const SmallRolling problem;
    const bool rolls = GENERATE(true, false);
    const Field rigid = problem.rigid(rolls ? 1 : 30), none(problem.grid.size());
    const auto scaled = [&](double factor) {
        Values bound = problem.bound;
        for (double& g : bound) g *= factor;
        return bound;
    };
    Observer observer;
    FrictionSolver solver(problem.bodies_of(rolls));
    Field last = tractions_of(solver.solve(task_of(problem.bound, rigid, none), observer));
    for (const double factor : {1.01, 1.011})
        last = tractions_of(solver.solve(task_of(scaled(factor), rigid, last), observer));
    const Values bound = scaled(1.0111);

    const FrictionSolution again = solver.solve(task_of(bound, rigid, last), observer);
    FrictionSolver fresh(problem.bodies_of(rolls));
    const FrictionSolution anew = fresh.solve(task_of(bound, rigid, last), observer);

    REQUIRE(again.evidence.converged);
    REQUIRE(anew.evidence.converged);
    CHECK(again.evidence.iterations < anew.evidence.iterations);
    for (std::size_t i = 0; i < bound.size(); ++i) {
        CHECK_THAT(again.traction_x[i], WithinAbs(anew.traction_x[i], 1e-5 * 3));
        CHECK_THAT(again.traction_y[i], WithinAbs(anew.traction_y[i], 1e-5 * 3));
    }
}

TEST_CASE("a contact area that has changed is taken as it is", "[newton]") {
    const SmallRolling problem;
    const Field rigid = problem.rigid(), none(problem.grid.size());
    Values bound = problem.bound;
    Observer observer;
    FrictionSolver solver(problem.bodies_of(true));
    const Field last = tractions_of(solver.solve(task_of(bound, rigid, none), observer));
    const double largest_bound = largest(bound);
    for (double& g : bound) g = g < 0.4 * largest_bound ? 0 : g;  // elements leave
    const FrictionSolution smaller = solver.solve(task_of(bound, rigid, last), observer);
    REQUIRE(smaller.evidence.converged);
    for (std::size_t i = 0; i < bound.size(); ++i)
        CHECK((smaller.element_division[i] == ElementState::exterior) == !(bound[i] > 0));
    const FrictionSolution larger = solver.solve(task_of(problem.bound, rigid, tractions_of(smaller)), observer);
    REQUIRE(larger.evidence.converged);
    for (std::size_t i = 0; i < bound.size(); ++i) CHECK_THAT(larger.traction_x[i], WithinAbs(last.x[i], 1e-5 * 3));
}

// This happens when an element has just come into contact, or when its slip has reversed.
TEST_CASE("elements that slip far start with a traction against their slip, whatever the estimate says", "[newton]") {
    const SmallRolling problem;
    const bool rolls = GENERATE(true, false);
    const double factor = GENERATE(0.0, -1.0);
    const Field rigid = problem.rigid(rolls ? 100 : 3000), none(problem.grid.size());
    Observer observer;
    FrictionSolver solver(problem.bodies_of(rolls));
    const FrictionSolution solution = solver.solve(task_of(problem.bound, rigid, none), observer);
    REQUIRE(count(solution).adhesion == 0);
    Field estimate = tractions_of(solution);
    for (std::size_t i = 0; i < problem.bound.size(); i += 3) {
        estimate.x[i] *= factor;
        estimate.y[i] *= factor;
    }
    const Contact contact(problem.bound, rigid.x, rigid.y);
    const auto compliance = compliance_of(problem.bodies_of(rolls), contact);
    FrictionNewton newton(*compliance, contact);

    newton.start(estimate);

    const Field &p = newton.tractions(), &s = newton.slip();
    for (std::size_t e = 0; e < contact.size(); ++e) {
        CHECK(newton.slips()[e]);
        CHECK(p.x[e] * s.x[e] + p.y[e] * s.y[e] < 0);
    }
    REQUIRE(newton.iterate(200, {1e-6, 200}, observer));
    CHECK(newton.evidence().iterations <= solution.evidence.iterations);
}

TEST_CASE("a correction of forces brings what is missing of them", "[newton]") {
    const SmallRolling problem;
    const Field rigid = problem.rigid();
    const Contact contact(problem.bound, rigid.x, rigid.y);
    const auto compliance = compliance_of(problem.bodies_of(true), contact);
    const std::size_t m = contact.size();
    Linearisation law(m);  // adhesion everywhere
    compliance->linearise(law);
    const auto given = GENERATE(std::array{true, true}, std::array{false, true});
    ForceBorder border({given, Pair(1, 2), 1e-6}, m);
    border.prepare(*compliance, law, 0);
    Field z(m);
    z.x = random_values(m, 1);
    z.y = random_values(m, 2);
    const double before = border.sum(z).x();
    const Pair missing(given[0] ? 0.7 : 0, -0.3);

    const Pair rigid_step = border.correct(z, missing);

    CHECK_THAT(border.sum(z).x(), WithinAbs(missing.x(), 1e-9));
    CHECK_THAT(border.sum(z).y(), WithinAbs(missing.y(), 1e-9));
    CHECK(rigid_step.y() != 0);
    if (!given[0]) {
        CHECK(before == 0);
        CHECK(rigid_step.x() == 0);
    }
}

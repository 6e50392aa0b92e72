// Tests outer iterations that reach their limit: the last one meets the tolerances and the prescribed forces.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

#include "curved_cases.hpp"
#include "random_contact.hpp"
#include "random_layers.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double normal_force = 40, mu = 0.3;

ContactProblem ball(const Body& upper, const Body& lower, int n = 20) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 4.0 / n, 4.0 / n);
    problem.bodies = {upper, lower};
    problem.gap = Paraboloid{50, 40};
    problem.Fn = normal_force;
    problem.friction = FrictionLaw{{mu}};
    return problem;
}

/// Creates steel on a soft body, in which friction changes the pressures.
ContactProblem dissimilar(int n = 20) {
    return ball({Material{82000, 0.28}}, {Material{200, 0.1}}, n);
}

/// Prescribes a force along x, and creepage across it.
Motion hauled(int which) {
    Rolling rolling{.eta = 1e-3, .force = {-0.5 * mu * normal_force, {}}};
    rolling.velocity = 1000;
    if (which == 0) return Shift{.force = {-0.5 * mu * normal_force, {}}};
    if (which == 2) rolling.kind = RollingKind::transient;
    return rolling;
}

void allow(ContactProblem& problem, int outer_iterations) {
    problem.settings.outer.max_iterations = outer_iterations;
}

/// The solvers within the last iteration have converged, and the force is met.
void check_last_iteration(const ContactProblem& problem, const ContactSolution& solution) {
    CHECK(solution.evidence.normal.converged);
    CHECK(solution.evidence.normal.residual <= problem.settings.normal.tolerance);
    REQUIRE(solution.evidence.tangential);
    CHECK(solution.evidence.tangential->converged);
    CHECK(solution.evidence.tangential->residual <= problem.settings.tangential.tolerance);
    CHECK_THAT(solution.forces.Fn, WithinRel(normal_force, 1e-8));
    const Force force = std::visit([](const auto& motion) { return motion.force; }, problem.motion);
    if (!force.Fx) return;
    REQUIRE(solution.evidence.force);
    CHECK(solution.evidence.force->converged);
    CHECK_THAT(solution.forces.Fx, WithinAbs(*force.Fx, 1e-5 * mu * normal_force));
}

/// Creates a cylinder of 120 elements between plates of 26 and 79 GPa. A reference program's creep force is -151.4 N
/// after one iteration and -149.7 N after all. The force of the other case is a share of the bound.
ContactProblem cylinder(double friction, const Rolling& motion) {
    ContactProblem problem;
    problem.grid = {120, 1, 0.004, 600, -0.24, -300};
    problem.bodies = Bodies::of({{26000, 0.33}, {79000, 0.3}});
    Values gap(120);
    for (int ix = 0; ix < 120; ++ix) gap[static_cast<std::size_t>(ix)] = 0.012 * std::pow(problem.grid.x(ix), 2);
    problem.gap = gap;
    problem.Fn = 9000;
    problem.friction = FrictionLaw{{friction}};
    Rolling rolling = motion;
    rolling.chi = std::numbers::pi;
    rolling.dq = 0.004;
    rolling.velocity = 500;
    problem.motion = rolling;
    return problem;
}

}  // namespace

TEST_CASE("one outer iteration is Johnson's process", "[outer]") {
    ContactProblem problem = cylinder(0.1, {.xi = 2.4e-4});
    allow(problem, 1);
    const ContactSolution once = solve_half_spaces(problem);
    CHECK_THAT(once.forces.Fx, WithinAbs(-151.4, 0.05));
    CHECK(once.evidence.tangential->converged);
    CHECK(once.evidence.tangential->residual <= problem.settings.tangential.tolerance);
    CHECK_FALSE(once.evidence.outer->converged);
    allow(problem, 30);
    const ContactSolution settled = solve_half_spaces(problem);
    CHECK(settled.converged());
    CHECK_THAT(settled.forces.Fx, WithinAbs(-149.7, 0.05));
}

TEST_CASE("a force is met by however few outer iterations", "[outer]") {
    ContactProblem problem = cylinder(5e-4, {.force = {0.3 * 5e-4 * 9000, {}}});
    const double settled = std::get<Rolling>(*solve_half_spaces(problem).motion).xi;
    for (const int limit : {1, 2, 3}) {
        allow(problem, limit);
        const ContactSolution solution = solve_half_spaces(problem);
        CHECK_THAT(solution.forces.Fx, WithinAbs(1.35, 5e-6));
        CHECK(solution.evidence.force->converged);
        CHECK_THAT(std::get<Rolling>(*solution.motion).xi, WithinRel(settled, 2e-2));
    }
}

TEST_CASE("the last outer iteration of dissimilar bodies obeys the law of friction", "[outer]") {
    ContactProblem problem = dissimilar();
    problem.motion = hauled(GENERATE(0, 1, 2));
    allow(problem, GENERATE(1, 2, 3));
    const ContactSolution solution = solve_half_spaces(problem);
    check_last_iteration(problem, solution);
    // This problem has the pressures of its own solution, even if they would still change.
    ContactProblem as_they_are = problem;
    as_they_are.Fn.reset();
    as_they_are.approach = solution.approach;
    const Values h = undeformed_distance(problem);
    const Surface u = displacements(problem, solution.pressure, solution.traction_x, solution.traction_y, 0, 0);
    Values gap(h.size());
    for (std::size_t i = 0; i < h.size(); ++i)
        gap[i] = solution.pressure[i] > 0 ? solution.approach - u.z[i] : solution.approach + 1;
    as_they_are.gap = gap;
    CHECK(contact_faults(as_they_are, solution, {}, 1e-4) == "");
}

TEST_CASE("outer iterations that are said to have converged have settled", "[outer]") {
    ContactProblem problem = dissimilar();
    problem.motion = hauled(GENERATE(0, 1));
    problem.settings.outer.tolerance = GENERATE(1e-1, 1e-2, 1e-4);
    ContactProblem exact = problem;
    exact.settings.outer.tolerance = 1e-9;
    const ContactSolution right = solve_half_spaces(exact);
    for (const int limit : {1, 2, 3, 4, 5, 6}) {
        allow(problem, limit);
        const ContactSolution solution = solve_half_spaces(problem);
        if (!solution.evidence.outer->converged) continue;
        double off = 0, all = 0;
        for (std::size_t i = 0; i < right.traction_x.size(); ++i) {
            off += std::pow(solution.traction_x[i] - right.traction_x[i], 2) +
                   std::pow(solution.traction_y[i] - right.traction_y[i], 2);
            all += std::pow(right.traction_x[i], 2) + std::pow(right.traction_y[i], 2);
        }
        CHECK(std::sqrt(off / all) < 2 * problem.settings.outer.tolerance);  // which is an estimate
    }
}

TEST_CASE("outer iterations of layers, curved strips and bodies that creep end as asked for", "[outer]") {
    const int limit = GENERATE(1, 2, 3);
    SECTION("layers") {
        const Body soft = Body::of(Layers{{{1.5, 200, 0.2}}, {82000, 0.28}});
        ContactProblem problem = ball({Material{82000, 0.28}}, soft);
        problem.motion = hauled(GENERATE(0, 1, 2));
        allow(problem, limit);
        check_last_iteration(problem, solve_layers(problem));
    }
    SECTION("curved strips of like bodies") {
        ContactProblem problem = ball({Material{1000, 0.28}}, {Material{1000, 0.28}});
        problem.gap = sampled(Paraboloid{50, 40}, problem.grid);
        problem.columns = ContactColumns{arc_frames(problem.grid.ny, problem.grid.dy, -5), 0, {}};
        problem.motion = hauled(GENERATE(0, 1));
        allow(problem, limit);
        check_last_iteration(problem, solve_strips(problem, rotated_pair(problem)));
    }
    SECTION("bodies that creep, one of them") {
        ContactProblem problem = dissimilar();
        problem.bodies.lower.viscoelastic = Viscoelasticity{1, 1e-3};
        problem.motion = hauled(1);
        allow(problem, limit);
        check_last_iteration(problem, solve_half_spaces(problem));
    }
}

TEST_CASE("forces are met by however few iterations of friction that follows slip or heat", "[outer]") {
    ContactProblem problem = ball({Material{82000, 0.28}}, {Material{82000, 0.28}});
    problem.gap = Paraboloid{460, 300};
    problem.Fn = 4e4;
    problem.grid = Grid::of_elements(21, 17, 0.6, 0.6);
    const double force = -0.5 * mu * *problem.Fn;
    Rolling rolling{.velocity = 2e4, .force = {force, {}}};
    if (GENERATE(true, false)) {
        problem.friction->temperature = TemperatureFriction{-0.1, 0, 100};
        problem.temperature = ThermalBodies{};
    } else {
        problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.2, 1000};
        if (GENERATE(true, false)) rolling.kind = RollingKind::transient;
    }
    problem.motion = rolling;
    allow(problem, GENERATE(1, 2, 3));
    const ContactSolution solution = solve_half_spaces(problem);
    CHECK(solution.evidence.tangential->converged);
    CHECK(solution.evidence.force->converged);
    CHECK_THAT(solution.forces.Fx, WithinAbs(force, 2e-6 * mu * *problem.Fn));
}

// Tests motions computed from forces: their cost, and whether they produce the forces, by solves of whole problems.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "counting_operator.hpp"
#include "random_contact.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double mu = 0.4, Fn = 9;

ContactProblem pressed(int n = 24) {
    ContactProblem problem = cattaneo_problem(n);
    problem.approach.reset();
    problem.Fn = Fn;
    return problem;
}

void ask_for(Motion& motion, std::optional<double> Fx, std::optional<double> Fy) {
    std::visit(
        [&](auto& asked) {
            asked.force.Fx = Fx;
            asked.force.Fy = Fy;
        },
        motion);
}

Motion without_forces(Motion motion) {
    ask_for(motion, {}, {});
    return motion;
}

struct Counted {
    ContactSolution solution;
    ProductCounts products;
};

Counted count(const ContactProblem& problem) {
    Counted result;
    Observer observer;
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    result.solution = solve_contact(problem, counted(influence, result.products), observer);
    return result;
}

class Listens : public Observer {
   public:
    void on_progress(const Progress& progress) override { heard = heard || progress.stage == "force"; }
    bool heard = false;
};

class CancelsWhenForcesAreSought final : public Listens {
   public:
    bool cancelled() const override { return heard; }
};

}  // namespace

TEST_CASE("forces of any size give back what the motion that they need gives", "[force]") {
    const double part = GENERATE(0.001, 0.3, 0.9, 0.99, 0.999), angle = GENERATE(0.4, -2.5);
    const Motion motion =
        GENERATE(Motion{Shift{.rotation = 1e-3}}, Motion{Rolling{.phi = 5e-3}},
                 Motion{Rolling{.phi = 5e-3, .chi = 0.6, .kind = RollingKind::transient, .steps = 2}});
    CAPTURE(part, angle, motion.index());
    ContactProblem problem = pressed();
    problem.motion = motion;
    const double Fx = part * mu * Fn * std::cos(angle), Fy = part * mu * Fn * std::sin(angle);
    ask_for(problem.motion, Fx, Fy);

    const ContactSolution by_forces = solve_half_spaces(problem);

    REQUIRE(by_forces.converged());
    CHECK(by_forces.evidence.force->residual <= 1e-6);
    CHECK(by_forces.evidence.force->iterations > 0);
    CHECK_THAT(by_forces.forces.Fx, WithinAbs(Fx, 2e-6 * mu * Fn));
    CHECK_THAT(by_forces.forces.Fy, WithinAbs(Fy, 2e-6 * mu * Fn));
    const auto* rolling = std::get_if<Rolling>(&motion);
    if (rolling != nullptr && !rolling->steady()) return;  // has a separate motion for each step
    problem.motion = without_forces(*by_forces.motion);
    const ContactSolution by_motion = solve_half_spaces(problem);
    REQUIRE(by_motion.converged());
    for (std::size_t i = 0; i < by_motion.pressure.size(); ++i) {
        CHECK_THAT(by_forces.traction_x[i], WithinAbs(by_motion.traction_x[i], 1e-4 * mu * by_motion.pmax));
        CHECK_THAT(by_forces.traction_y[i], WithinAbs(by_motion.traction_y[i], 1e-4 * mu * by_motion.pmax));
    }
}

TEST_CASE("a component without a force keeps its motion, and the other one is found", "[force]") {
    ContactProblem problem = pressed();
    problem.motion = GENERATE(Motion{Shift{.rigid_shift = {0.004, 0.5}}}, Motion{Rolling{.xi = 0.004, .eta = 0.5}});
    ask_for(problem.motion, {}, 0.2 * mu * Fn);
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fy, WithinAbs(0.2 * mu * Fn, 2e-6 * mu * Fn));
    const double kept = std::visit(
        [](const auto& found) {
            if constexpr (requires { found.xi; })
                return found.xi;
            else
                return found.rigid_shift.x;
        },
        *solution.motion);
    CHECK(kept == 0.004);
    CHECK(contact_faults(problem, solution, {}, 1e-4) == "");
}

// A search around whole solves takes at least four of them.
TEST_CASE("forces cost less than two solves of the motion that they need", "[force]") {
    ContactProblem problem = pressed(30);
    problem.motion =
        GENERATE(Motion{Shift{}}, Motion{Rolling{.phi = 5e-3}}, Motion{Rolling{.kind = RollingKind::transient}});
    CAPTURE(problem.motion.index());
    ask_for(problem.motion, -0.5 * mu * Fn, 0.4 * mu * Fn);

    const Counted by_forces = count(problem);
    problem.motion = without_forces(*by_forces.solution.motion);
    const Counted by_motion = count(problem);

    REQUIRE(by_forces.solution.converged());
    REQUIRE(by_motion.solution.converged());
    CHECK(by_forces.products.tangential < 2 * by_motion.products.tangential);
}

TEST_CASE("a step of a transient starts from the motion of the step before", "[force]") {
    ContactProblem problem = pressed();
    Rolling rolling{.phi = 5e-3, .kind = RollingKind::transient, .steps = 30};
    problem.motion = rolling;
    ask_for(problem.motion, -0.5 * mu * Fn, 0);
    const ContactSolution before = solve_half_spaces(problem);
    REQUIRE(before.converged());
    rolling = std::get<Rolling>(*before.motion);
    rolling.steps = 1;
    problem.motion = rolling;
    problem.previous = {before.pressure, before.traction_x, before.traction_y};
    problem.initial.pressure = before.pressure;
    problem.initial.traction_x = before.traction_x;
    problem.initial.traction_y = before.traction_y;
    const ContactSolution next = solve_half_spaces(problem);
    REQUIRE(next.converged());
    CHECK(2 * next.evidence.tangential->iterations < before.evidence.tangential->iterations);
}

TEST_CASE("the search for a motion is reported, and ends when it is cancelled", "[force]") {
    ContactProblem problem = pressed();
    problem.motion = GENERATE(Motion{Shift{}}, Motion{Rolling{}});
    ask_for(problem.motion, -0.5 * mu * Fn, 0);
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    Listens listens;
    solve_contact(problem, influence, listens);
    CHECK(listens.heard);
    CancelsWhenForcesAreSought cancels;
    CHECK_THROWS_AS(solve_contact(problem, influence, cancels), Cancelled);
}

TEST_CASE("forces that are not found in time leave a solution that says so", "[force]") {
    ContactProblem problem = pressed();
    problem.motion = Rolling{.phi = 5e-3, .force = {-0.9 * mu * Fn, 0.3 * mu * Fn}};
    problem.settings.tangential.max_iterations = 2;
    problem.settings.outer.max_iterations = 1;
    const ContactSolution solution = solve_half_spaces(problem);
    CHECK_FALSE(solution.converged());
    CHECK_FALSE(solution.evidence.force->converged);
    CHECK(solution.evidence.force->residual > 1e-6);
}

// Tests dissimilar bodies on many elements: outer iterations on the fine grid start from those on the coarser one.
#include "contact/outer/coarse_outer_iterations.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "plain_operator.hpp"
#include "random_contact.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinRel;

namespace {

ContactProblem ellipse(int n, const Motion& motion) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 13.0 / n, 8.6 / n);
    problem.bodies = Bodies::of({{82000, 0.28}, {41000, 0.1}});
    problem.gap = SemiAxes{6, 4};
    problem.Fn = 50000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = motion;
    return problem;
}

/// These motions and forces cause slip in about half of the contact.
const Motion rolls = Rolling{.xi = 0.002, .eta = 0.001, .phi = 1e-4};
const Motion shifts = Shift{.rigid_shift = {0.01, 0.005}};
const Motion rolls_by_force = Rolling{.phi = 1e-4, .force = {-8000, {}}};
const Motion shifts_by_force = Shift{.force = {-8000, -3000}};

struct Example {
    ContactProblem problem;
    ContactInfluence influence = operators_of(problem, pair_table(problem));
    Values distance = undeformed_distance(problem);
    Observer observer{};

    std::optional<OuterStart> start(const Values& bound) {
        return outer_iterations_on_coarser(problem, influence, distance, bound, observer);
    }
};

}  // namespace

TEST_CASE("outer iterations on the coarser grid find about the tractions and the motion of the fine one",
          "[dissimilar]") {
    Example example{ellipse(48, GENERATE(rolls, shifts, rolls_by_force, shifts_by_force))};
    const ContactSolution solution = solve_contact(example.problem, example.influence, example.observer);
    REQUIRE(solution.converged());
    CHECK(contact_faults(example.problem, solution, {}, 1e-4) == "");
    Values bound = solution.pressure;
    for (double& g : bound) g *= 0.3;
    const auto start = example.start(bound);
    REQUIRE(start);
    double error = 0, size = 0;
    for (std::size_t i = 0; i < bound.size(); ++i) {
        const double x = start->tractions.x[i], y = start->tractions.y[i];
        CHECK(std::hypot(x, y) <= bound[i] * (1 + 1e-12));
        error += std::pow(x - solution.traction_x[i], 2) + std::pow(y - solution.traction_y[i], 2);
        size += std::pow(solution.traction_x[i], 2) + std::pow(solution.traction_y[i], 2);
    }
    CHECK(std::sqrt(error / size) < 0.2);
    if (const auto* rolling = std::get_if<Rolling>(&start->motion))
        CHECK_THAT(rolling->xi, WithinRel(std::get<Rolling>(*solution.motion).xi, 0.05));
    else
        CHECK_THAT(std::get<Shift>(start->motion).rigid_shift.x,
                   WithinRel(std::get<Shift>(*solution.motion).rigid_shift.x, 0.05));
}

TEST_CASE("there is nothing to start from without many elements or a coarser grid", "[dissimilar]") {
    Example example{ellipse(48, rolls)};
    const Values all(example.problem.grid.size(), 1), none(all.size());
    CHECK(example.start(all));
    CHECK_FALSE(example.start(none));
    example.influence.current = std::make_shared<PlainOperator>(example.influence.current);
    CHECK_FALSE(example.start(all));
}

TEST_CASE("outer iterations start on the fine grid where elements have friction, slip or tractions of their own",
          "[dissimilar]") {
    Example example{ellipse(48, rolls)};
    const std::size_t n = example.problem.grid.size();
    const Values all(n, 1);
    ContactProblem& problem = example.problem;
    SECTION("friction") {
        problem.friction->mu.assign(n, 0.3);
    }
    SECTION("falling friction") {
        problem.friction->kinetic = KineticFriction{};
    }
    SECTION("slip") {
        problem.rigid_slip = {Values(n), Values(n)};
    }
    SECTION("a step before") {
        problem.previous.pressure = all;
    }
    SECTION("an estimate") {
        problem.initial.traction_x = all;
    }
    SECTION("a force under an approach") {
        problem.Fn.reset();
        problem.approach = 0.03;
        problem.motion = rolls_by_force;
    }
    SECTION("a force that friction just holds") {
        problem.motion = Shift{.force = {-0.995 * 0.3 * 50000, {}}};
    }
    CHECK_FALSE(example.start(all));
}

TEST_CASE("many elements of dissimilar bodies meet a force that friction just holds", "[dissimilar]") {
    Example example{ellipse(48, Shift{.force = {-0.999 * 0.3 * 50000, {}}})};
    const ContactSolution solution = solve_contact(example.problem, example.influence, example.observer);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fx, WithinRel(-0.999 * 0.3 * 50000, 1e-5));
}

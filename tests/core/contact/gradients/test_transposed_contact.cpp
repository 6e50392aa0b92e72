// Tests that the transposed equations of a frozen contact are the transpose of its equations.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contact/derivatives/frozen_contact.hpp"
#include "contact/random_layers.hpp"
#include "contactd/rotated_strips.hpp"
#include "gradient_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

using Vector = FrozenContact::Vector;

struct Solved {
    ContactProblem problem;
    ContactInfluence influence;
    ContactSolution solution;
};

Solved solved(const ContactProblem& problem, const ContactInfluence& influence) {
    Observer observer;
    ContactSolution solution = solve_contact(problem, influence, observer);
    if (const auto* rolling = std::get_if<Rolling>(&problem.motion))
        for (auto* slip : {&solution.slip_x, &solution.slip_y})
            for (double& s : *slip) s *= step_length(*rolling, problem.grid);
    return {problem, influence, solution};
}

Vector random_vector(Eigen::Index size, unsigned seed) {
    const Values values = random_values(static_cast<std::size_t>(size), seed);
    return Eigen::Map<const Vector>(values.data(), size);
}

/// Returns the difference of <J u, v> and <u, J^T v> for random vectors, over their sizes.
double transpose_error(const Solved& contact) {
    FrozenContact original(contact.problem, contact.influence, contact.solution);
    FrozenContact transposed(contact.problem, contact.influence, contact.solution,
                             FrozenContact::Equations::transposed);
    REQUIRE(original.tractions() > 0);
    const bool all = original.coupled();
    const Eigen::Index size = (all ? original.pressures() : 0) + original.tractions();
    const Vector u = random_vector(size, 1), v = random_vector(size, 2);
    Vector ju(size), jv(size);
    all ? original.all(u, ju) : original.tangential(u, ju);
    all ? transposed.all(v, jv) : transposed.tangential(v, jv);
    return std::abs(ju.dot(v) - u.dot(jv)) / (ju.norm() * v.norm());
}

Motion random_motion_of(int kind) {
    if (kind == 0) return Shift{{0.02, 0.01}, 1e-3};
    Rolling rolling{.xi = 0.002, .eta = 0.001, .phi = 1e-4};
    if (kind == 2) rolling.chi = 2.3;
    if (kind == 3) rolling.dq = 0.45;
    if (kind == 4) rolling.kind = RollingKind::transient;
    return rolling;
}

}  // namespace

TEST_CASE("transposed equations of half-spaces are the transpose", "[gradients]") {
    ContactProblem problem = GENERATE(0, 1) == 0 ? rolling_steel() : rolling_on_softer();
    problem.motion = random_motion_of(GENERATE(0, 1, 2, 3, 4));
    CHECK(transpose_error(solved(problem, operators_of(problem, pair_table(problem)))) <= 1e-10);
}

TEST_CASE("transposed equations of layers are the transpose", "[gradients]") {
    ContactProblem problem = rolling_steel();
    const Body layered = Body::of(Layers{{{0.5, 2000, 0.4}, {1, 50000, 0.3}}, {82000, 0.28}});
    problem.bodies = GENERATE(0, 1) == 0 ? Bodies{layered, layered} : Bodies{{{82000, 0.28}}, layered};
    problem.motion = random_motion_of(GENERATE(0, 1, 2, 3));
    CHECK(transpose_error(solved(problem, layered_influence(problem))) <= 1e-10);
}

TEST_CASE("transposed equations of a given table are the transpose", "[gradients]") {
    ContactProblem problem = rolling_on_softer();
    const IcTable pair = pair_table(problem);
    problem.bodies.pair = GivenIcs{pair, problem.grid.dx, problem.grid.dy};
    problem.motion = random_motion_of(GENERATE(0, 1, 3));
    CHECK(transpose_error(solved(problem, make_influence(problem, pair))) <= 1e-10);
}

TEST_CASE("transposed equations of strips are the transpose", "[gradients]") {
    ContactProblem problem = rolling_steel();
    Ics ics;
    ics.body = BodyShape::longitudinally_uniform;
    ics.section = Section{EdgeBlock{100, 50, 3}};
    problem.bodies = {{{82000, 0.28}, ics}, {{82000, 0.28}, ics}};
    problem.motion = random_motion_of(GENERATE(0, 1, 3));
    Grid longer = problem.grid;
    longer.nx += 2;
    const BodyTable strips{rotated_strips(*ics.section, longer, {82000, 0.28}, LoadShape::constant)};
    CHECK(transpose_error(solved(problem, make_influence(problem, strips, strips))) <= 1e-10);
}

TEST_CASE("a table that violates reciprocity is refused", "[gradients]") {
    ContactProblem problem = rolling_steel();
    IcTable pair = pair_table(problem);
    for (int l = 1; l < pair.ny; ++l)
        for (int k = 1; k < pair.nx; ++k) pair(Axis::x, Axis::y, k, l) *= 1.01;
    problem.bodies.pair = GivenIcs{pair, problem.grid.dx, problem.grid.dy};
    const ContactInfluence influence = make_influence(problem, pair);
    Observer observer;
    const ContactSolution solution = solve_contact(problem, influence, observer);
    CHECK_THROWS_MATCHES(
        contact_gradients(problem, influence, solution, {output_of(&Cotangents::Fx)}, {}, observer), InvalidArgument,
        MessageMatches(ContainsSubstring("vjp requires influence coefficients that satisfy reciprocity")));
}

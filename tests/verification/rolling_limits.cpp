// Tests limits of rolling problems: full slip, spin, and the simplified models against the full one.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contact/contact_cases.hpp"
#include "contactd/solve_contact.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double mu = 0.3, Fn = 50000, bound = mu * Fn;

ContactProblem ellipse(double a, double b, const Material& material, int n, const Rolling& rolling) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 2.2 * a / n, 2.2 * b / n);
    problem.bodies = Bodies::of({material, material});
    problem.gap = SemiAxes{a, b};
    problem.Fn = Fn;
    problem.friction.emplace();
    problem.friction->mu = {mu};
    problem.motion = rolling;
    return problem;
}

ContactSolution solved(const ContactProblem& problem) {
    Observer observer;
    if (problem.model != Model::full) return solve_contact(problem, {}, observer);
    const ContactInfluence influence =
        make_influence(problem, half_space_pair(problem.grid, problem.bodies.upper.material));
    ContactSolution solution = solve_contact(problem, influence, observer);
    REQUIRE(solution.converged());
    return solution;
}

Rolling creepages(double xi, double eta, double phi) {
    Rolling rolling;
    rolling.xi = xi;
    rolling.eta = eta;
    rolling.phi = phi;
    return rolling;
}

}  // namespace

TEST_CASE("full slip carries mu Fn against the creepage", "[verification]") {
    const double angle = GENERATE(0.0, 2.0);
    const auto solution =
        solved(ellipse(6, 4, {82000, 0.28}, 25, creepages(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0)));
    CHECK_THAT(solution.forces.Fx, WithinAbs(-bound * std::cos(angle), 1e-3 * bound));
    CHECK_THAT(solution.forces.Fy, WithinAbs(-bound * std::sin(angle), 1e-3 * bound));
    CHECK(solution.elements.adhesion == 0);
}

TEST_CASE("spin alone pushes sideways and turns against itself", "[verification]") {
    const auto solution = solved(ellipse(6, 4, {82000, 0.28}, 25, creepages(0, 0, 2e-4)));
    CHECK_THAT(solution.forces.Fx, WithinAbs(0, 1e-3 * bound));
    CHECK(solution.forces.Fy < -0.2 * bound);
    CHECK(solution.forces.Mz < 0);
}

TEST_CASE("simplified models come near the full one", "[verification]") {
    const double ratio = GENERATE(0.3, 1.0, 3.0), size = GENERATE(0.3, 1.0), spin = GENERATE(-1.0, 0.0, 1.0);
    const double a = 5 * std::sqrt(ratio), b = 5 / std::sqrt(ratio), unit = bound / (82000.0 * 25);
    ContactProblem problem =
        ellipse(a, b, {82000, 0.28}, 30, creepages(0.18 * size * unit, 0.18 * size * unit, 0.05 * spin * unit));
    const auto full = solved(problem);
    const auto error = [&](Model model) {
        problem.model = model;
        const auto simplified = solved(problem);
        CHECK_THAT(simplified.pmax, WithinRel(full.pmax, 0.01));
        return std::hypot(simplified.forces.Fx - full.forces.Fx, simplified.forces.Fy - full.forces.Fy) / bound;
    };
    CHECK(error(Model::fastsim) < 0.1);
    if (spin == 0) CHECK(error(Model::hertz) < 0.08);
}

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "closed_forms/dual.hpp"
#include "contact/random_derivatives.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Creates elliptic contacts on half-spaces, with prescribed approach or force, in partial or full slip.
ContactProblem random_simplified(std::uint64_t seed) {
    Dice dice(seed + 5'000'000);
    ContactProblem problem;
    problem.grid = Grid::of_elements(12, 12, 14, 14);
    problem.bodies = Bodies::of(random_bodies(dice));
    const double R = dice.log_uniform(50, 1000);
    problem.gap = Paraboloid{R, R * dice.log_uniform(0.1, 10)};
    problem.approach = dice.log_uniform(1e-3, 0.1);
    problem.model = dice.chance(0.5) ? Model::hertz : Model::fastsim;
    const ContactSolution normal = solve_half_spaces(problem);
    if (dice.chance(0.5)) {
        problem.Fn = normal.forces.Fn;
        problem.approach.reset();
    }
    problem.derivatives = true;
    if (dice.chance(0.1)) return problem;
    const double mu = dice.uniform(0.05, 0.6);
    problem.friction = FrictionLaw{{mu}};
    const double unit = slip_unit(problem, normal, mu), length = std::sqrt(normal.area.contact);
    const double size = dice.chance(0.1) ? 0 : unit * dice.log_uniform(0.01, 3), angle = dice.uniform(0, 6.3);
    if (problem.model == Model::hertz && dice.chance(0.5)) {
        problem.motion = Shift{{size * std::cos(angle), size * std::sin(angle)}};
        return problem;
    }
    Rolling rolling;
    rolling.chi = dice.integer(0, 3) * 0.5 * 3.14159265358979323846;
    rolling.xi = size / length * std::cos(angle);
    rolling.eta = size / length * std::sin(angle);
    if (problem.model == Model::fastsim && dice.chance(0.7))
        rolling.phi = unit / (length * length) * dice.uniform(-2, 2);
    problem.motion = rolling;
    return problem;
}

}  // namespace

TEST_CASE("derivatives of simplified models are central differences", "[derivatives][random]") {
    int compared = 0, skipped = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        const ContactProblem problem = random_simplified(seed);
        const ContactSolution solution = solve_half_spaces(problem);
        REQUIRE(solution.derivatives);
        CHECK(solution.evidence.derivatives->converged);
        const bool spins = problem.model == Model::fastsim && problem.friction;
        CHECK((!problem.friction || (solution.derivatives->Fx->phi.has_value() == spins)));
        InputSizes sizes = input_sizes(problem, solution);
        const DerivativeCheck check = check_derivatives(problem, solution);
        CAPTURE(check.worst, check.error, sizes.size[0]);
        CHECK(check.error <= 1e-4);
        compared += check.compared;
        skipped += check.skipped;
    }
    CHECK(compared > 600);
    CHECK(skipped < compared / 10);
}

TEST_CASE("simplified models have no derivative by friction where there is none", "[derivatives]") {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        ContactProblem problem = random_simplified(seed);
        if (!problem.friction) continue;
        problem.friction->mu = {0};
        const ContactSolution solution = solve_half_spaces(problem);
        REQUIRE(solution.derivatives);
        CHECK(!solution.derivatives->Fx->mu);
        CHECK((problem.Fn ? solution.derivatives->Fx->Fn : solution.derivatives->Fx->approach) == 0.0);
    }
}

TEST_CASE("duals differentiate what they compute", "[derivatives]") {
    const Dual x = Dual::input(1.7, 0), y = Dual::input(-0.6, 1);
    const Dual f = sqrt(x * x + 3 * y * y) / (2 - y) - abs(y) * x;
    const double root = std::sqrt(1.7 * 1.7 + 3 * 0.36);
    CHECK_THAT(f.value, WithinRel(root / 2.6 - 0.6 * 1.7, 1e-14));
    CHECK_THAT(f.by[0], WithinRel(1.7 / root / 2.6 - 0.6, 1e-14));
    CHECK_THAT(f.by[1], WithinRel(-1.8 / root / 2.6 + root / (2.6 * 2.6) + 1.7, 1e-14));
    CHECK_THAT(f.by[2], WithinAbs(0, 0));
}

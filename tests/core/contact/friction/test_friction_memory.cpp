// Tests friction with two terms and with memory against values of another program for the same equations, and closed
// forms.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "../contact_cases.hpp"

namespace contactd::test {
namespace {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

KineticFriction two_terms(SlipLaw law, double distance) {
    const double scale = law == SlipLaw::linear ? 2 : law == SlipLaw::exponential ? 1 / std::numbers::ln2 : 1;
    KineticFriction kinetic{law, 0.15, scale * 60};
    kinetic.second = SecondTerm{0.08, scale * 25};
    if (distance > 0) kinetic.memory = FrictionMemory{distance, 1};
    return kinetic;
}

ContactProblem steel_ellipse(const KineticFriction& kinetic, double xi, double eta, double phi) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(17, 15, 0.65, 0.6);
    const Material steel{82000, 0.28};
    problem.bodies = Bodies::of(MaterialPair{steel, steel});
    problem.gap = Paraboloid{460, 300};
    problem.Fn = 30000;
    problem.friction = FrictionLaw{{0.35}, kinetic, InterfacialLayer{1e-5}};
    problem.motion = Rolling{.xi = xi, .eta = eta, .phi = phi, .dq = 0.65, .velocity = 8000};
    problem.settings.tangential.tolerance = problem.settings.outer.tolerance = 1e-9;
    problem.settings.normal.tolerance = 1e-11;
    return problem;
}

ContactSolution converged(const ContactProblem& problem) {
    ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.evidence.outer.has_value());
    CAPTURE(solution.evidence.outer->residual, solution.evidence.outer->iterations);
    REQUIRE(solution.converged());
    return solution;
}

}  // namespace

TEST_CASE("falling friction of two terms with memory has the given forces", "[friction_memory]") {
    struct Given {
        SlipLaw law;
        double distance, xi, eta, phi, Fx, Fy, Mz, least, most;
        int adhesion;
    };
    const auto given = GENERATE(
        Given{SlipLaw::exponential, 0.003, 4e-3, 1e-3, 1e-4, -8091.60198, -2302.97605, -1149.492, 0.225320076,
              0.34998896, 6},
        Given{SlipLaw::linear, 0.002, 6e-3, 0, 2e-4, -7145.48443, -313.570526, -857.627963, 0.19512275, 0.330865888, 0},
        Given{SlipLaw::exponential, 0, 4e-3, 1e-3, 1e-4, -7720.69137, -2188.75894, -1019.04706, 0.221312566, 0.35, 6});
    const ContactSolution solution =
        converged(steel_ellipse(two_terms(given.law, given.distance), given.xi, given.eta, given.phi));
    CHECK_THAT(solution.forces.Fx, WithinRel(given.Fx, 1e-7));
    CHECK_THAT(solution.forces.Fy, WithinRel(given.Fy, 1e-7));
    CHECK_THAT(solution.forces.Mz, WithinRel(given.Mz, 1e-7));
    CHECK(solution.elements.adhesion == given.adhesion);
    double least = 1, most = 0;
    for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
        if (!(solution.pressure[i] > 0)) continue;
        least = std::min(least, solution.friction_coefficient[i]);
        most = std::max(most, solution.friction_coefficient[i]);
    }
    CHECK_THAT(least, WithinRel(given.least, 1e-7));
    CHECK_THAT(most, WithinRel(given.most, 1e-7));
}

TEST_CASE("the creep curve with a layer and memory has the published forces", "[friction_memory]") {
    const auto [xi, force] = GENERATE(std::pair(1e-5, 1.869e-3), std::pair(0.003, 0.4928), std::pair(0.015, 0.9442),
                                      std::pair(0.15, 0.6755));
    const double a = 6.30360, b = 12.60719;
    KineticFriction kinetic{SlipLaw::exponential, 0.14, 1250 / std::numbers::ln2};
    kinetic.memory = FrictionMemory{0.003, 1};
    ContactProblem problem = steel_ellipse(kinetic, xi, 0, 0);
    problem.grid = Grid::of_elements(48, 44, 2.2 * a / 48, 2.2 * b / 44);
    problem.gap = Paraboloid{1 / (2 * 8e-4), 1 / (2 * 2.814173e-4)};
    problem.Fn = 106700;
    problem.friction = FrictionLaw{{0.33}, kinetic, InterfacialLayer{1.25 / 8200}};
    problem.motion = Rolling{.xi = xi, .dq = problem.grid.dx, .velocity = 10000};
    CHECK_THAT(-converged(problem).forces.Fx / (0.33 * 106700), WithinRel(force, 3e-4));
}

TEST_CASE("memory that is short is none, and memory that is long leaves the static coefficient", "[friction_memory]") {
    const ContactSolution none = converged(steel_ellipse(two_terms(SlipLaw::exponential, 0), 4e-3, 1e-3, 1e-4));
    const ContactSolution brief = converged(steel_ellipse(two_terms(SlipLaw::exponential, 1e-12), 4e-3, 1e-3, 1e-4));
    CHECK_THAT(brief.forces.Fx, WithinRel(none.forces.Fx, 1e-6));
    ContactProblem problem = steel_ellipse(two_terms(SlipLaw::exponential, 1e9), 4e-3, 1e-3, 1e-4);
    const ContactSolution lasting = converged(problem);
    problem.friction->kinetic.reset();
    CHECK_THAT(lasting.forces.Fx, WithinRel(solve_half_spaces(problem).forces.Fx, 1e-6));
}

TEST_CASE("two equal terms are one", "[friction_memory]") {
    const auto law = GENERATE(SlipLaw::linear, SlipLaw::exponential);
    KineticFriction one{law, 0.15, 100}, two = one;
    two.second = SecondTerm{0.05, 100};
    for (const double v : {0.0, 1.0, 30.0, 99.0, 150.0, 1e5})
        CHECK_THAT(friction_coefficient(two, 0.35, v), WithinRel(friction_coefficient(one, 0.35, v), 1e-14));
}

TEST_CASE("terms have halved where they say so", "[friction_memory]") {
    KineticFriction kinetic{SlipLaw::rational, 0.1, 60};
    CHECK_THAT(friction_coefficient(kinetic, 0.3, 60), WithinRel(0.2, 1e-14));
    kinetic.second = SecondTerm{0.2, 25};
    CHECK_THAT(friction_coefficient(kinetic, 0.3, 25), WithinRel(0.2, 1e-14));
    CHECK_THAT(friction_coefficient(kinetic, 0.3, 50), WithinRel(0.1 + 0.2 / 5, 1e-14));
}

TEST_CASE("transient rolling with memory ends as steady rolling", "[friction_memory]") {
    ContactProblem problem = steel_ellipse(two_terms(SlipLaw::exponential, 0.003), 4e-3, 1e-3, 1e-4);
    problem.settings.tangential.tolerance = problem.settings.outer.tolerance = 1e-7;
    const ContactSolution steady = converged(problem);
    auto& rolling = std::get<Rolling>(problem.motion);
    rolling.kind = RollingKind::transient;
    rolling.steps = 60;
    const ContactSolution transient = converged(problem);
    CHECK_THAT(transient.forces.Fx, WithinRel(steady.forces.Fx, 1e-3));
}

TEST_CASE("an element that shifts on follows the law over the distance it slips", "[friction_memory]") {
    // Uses mu(k) = mu_inf + (mu_0 - mu_inf) exp(-slipped/d), to first order in the step.
    ContactProblem problem;
    problem.grid = Grid::of_elements(1, 1, 1, 1);
    const Material stiff{1e12, 0.28};
    problem.bodies = Bodies::of(MaterialPair{stiff, stiff});
    problem.gap = Paraboloid{1e6, 1e6};
    problem.Fn = 100;
    KineticFriction kinetic{SlipLaw::exponential, 0.15, 1e-5};
    kinetic.memory = FrictionMemory{0.1, 0};
    problem.friction = FrictionLaw{{0.4}, kinetic, {}};
    problem.motion = Shift{{1e-3, 0}};
    for (int step = 1; step <= 100; ++step) {
        const ContactSolution solution = converged(problem);
        problem.previous = {
            solution.pressure, solution.traction_x, solution.traction_y, {}, solution.friction_coefficient};
        const double mu = 0.15 + 0.25 * std::exp(-step * 1e-3 / 0.1);
        CHECK_THAT(-solution.traction_x[0] / 100, WithinAbs(mu, 1.5e-3));
    }
}

TEST_CASE("memory and terms are refused where they make no sense", "[friction_memory]") {
    const auto refused = [](const KineticFriction& kinetic) -> std::string {
        try {
            solve_half_spaces(steel_ellipse(kinetic, 4e-3, 0, 0));
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return {};
    };
    KineticFriction kinetic = two_terms(SlipLaw::linear, 1);
    kinetic.second->fall = 0.3;
    CHECK(refused(kinetic) == "friction.kinetic.second.fall");
    kinetic = two_terms(SlipLaw::linear, 1);
    kinetic.memory->distance = -1;
    CHECK(refused(kinetic) == "friction.kinetic.memory.distance");
    kinetic.memory = FrictionMemory{1, -1};
    CHECK(refused(kinetic) == "friction.kinetic.memory.least_velocity");
}

}  // namespace contactd::test

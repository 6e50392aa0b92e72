// Tests steady rolling on contacts of many elements, which the preconditioner of slip accelerates.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <memory>

#include "random_contact.hpp"
#include "rolling_cases.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Material steel{82000, 0.28};

/// Uses semi-axes of 6 x 4 mm, about 1000 N/mm^2, mu 0.3, on n x n elements.
RollingCase ellipse(int n) {
    return {Grid::of_elements(n, n, 12.0 / n, 8.0 / n), steel, 300, 0, 12.0 / n};
}

struct Iterations {
    int cold, warm;
};
Iterations iterations(RollingCase& rolling) {
    rolling.set(0.002, 0.001, 1e-4);
    const RollingSolution cold = rolling.steady();
    rolling.set(0.0021, 0.00105, 1.05e-4);
    const RollingSolution warm = rolling.steady({}, cold.traction_x, cold.traction_y);
    CHECK(cold.evidence.converged);
    CHECK(warm.evidence.converged);
    return {cold.evidence.iterations, warm.evidence.iterations};
}

/// Represents a step operator without functions that accelerate solves.
class PlainStep final : public StepOperator {
   public:
    explicit PlainStep(const StepOperator& inner) : inner_(inner) {}
    std::size_t size() const override { return inner_.size(); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        inner_.tangential(px, py, ux, uy);
    }
    bool coupled() const override { return inner_.coupled(); }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        inner_.tangential_of_normal(pz, ux, uy);
    }
    std::size_t bytes() const override { return inner_.bytes(); }

   private:
    const StepOperator& inner_;
};

RollingSolution without_inverses(const RollingCase& rolling) {
    const PlainStep plain(rolling.increment);
    const RollingBodies bodies{rolling.influence, plain, rolling.grid, rolling.step_x, rolling.step_y};
    const RigidSlip w = rigid_slip(rolling.grid, rolling.rolling, rolling.dq);
    Observer observer;
    return solve_steady_rolling(bodies, rolling.bound, w.x, w.y, {}, {}, {}, observer);
}

}  // namespace

TEST_CASE("iterations of steady rolling do not grow with the grid", "[rolling]") {
    RollingCase small = ellipse(25), large = ellipse(96);
    const auto [cold, warm] = iterations(small);
    const auto [large_cold, large_warm] = iterations(large);
    CHECK(large_cold <= cold);
    CHECK(large_warm <= warm);
}

TEST_CASE("friction law holds on many elements in any direction", "[rolling]") {
    const auto [chi, elements_per_step] = GENERATE(std::pair{0.0, 1.0}, std::pair{0.7, 0.4}, std::pair{-2.0, 2.0});
    RollingCase rolling(Grid::of_elements(74, 72, 2.0 / 74, 1.4 / 72), {1000, 0.28}, 3, chi,
                        elements_per_step * 2.0 / 74);
    rolling.set(0.001, -0.0005, 0.001);
    CAPTURE(chi, elements_per_step);
    const RollingSolution solution = rolling.steady();
    check_steady_law(rolling, solution, 2e-5);
    CHECK(count(solution).adhesion + count(solution).slip > 4000);
    CHECK(solution.evidence.iterations <= without_inverses(rolling).evidence.iterations);
}

TEST_CASE("many elements slip one and all", "[rolling]") {
    RollingCase rolling(Grid::of_elements(74, 72, 2.0 / 74, 1.4 / 72), {1000, 0.28}, 3, 0, 2.0 / 74);
    rolling.set(0.1, 0.05, 0);
    const RollingSolution solution = rolling.steady();
    check_steady_law(rolling, solution, 2e-5);
    CHECK(count(solution).adhesion == 0);
}

TEST_CASE("a step without inverses rolls to the same tractions", "[rolling]") {
    RollingCase rolling = ellipse(72);
    rolling.set(0.002, 0.001, 1e-4);
    const RollingSolution expected = rolling.steady();
    const RollingSolution solution = without_inverses(rolling);

    REQUIRE(solution.evidence.converged);
    CHECK(solution.evidence.iterations > expected.evidence.iterations);
    for (std::size_t i = 0; i < rolling.bound.size(); ++i) {
        CHECK_THAT(solution.traction_x[i], WithinAbs(expected.traction_x[i], 0.01));
        CHECK_THAT(solution.traction_y[i], WithinAbs(expected.traction_y[i], 0.01));
    }
}

TEST_CASE("dissimilar bodies roll on many elements", "[rolling]") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(78, 78, 12.8 / 78, 8.4 / 78);
    problem.bodies = Bodies::of({steel, {8000, 0.1}});
    problem.gap = SemiAxes{6, 4};
    problem.Fn = 20000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 0.002, .eta = -0.001, .phi = 2e-4, .chi = GENERATE(0.0, 1.0)};
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK(solution.elements.contact > 4000);
    CHECK(contact_faults(problem, solution, {}, 1e-4) == "");
}

TEST_CASE("a line contact of thousands of elements is Carter's", "[rolling]") {
    constexpr int n = 5000;
    const MaterialPair bodies{steel, steel};
    const auto line = reference::line_contact(bodies, 250, 2000);
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, 1, 2.1 * line.half_width / n, 1);
    Ics ics;
    ics.line_contact = LineContactSpec{1000};
    problem.bodies = Bodies::of(bodies, ics);
    problem.gap = Paraboloid{250};
    problem.Fn = 2000;
    problem.friction = FrictionLaw{{0.3}};
    const auto carter = reference::carter_of_force(bodies, line, 0.3, 300);
    problem.motion = Rolling{.xi = carter.creepage};
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK(solution.elements.contact > 4000);
    CHECK_THAT(std::abs(solution.forces.Fx), WithinRel(300.0, 2e-3));
}

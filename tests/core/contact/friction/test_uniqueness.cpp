#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "../contact_cases.hpp"
#include "contact/warnings/uniqueness.hpp"

namespace contactd::test {
namespace {

// Creates a row of long elements under 622 kN, the first of the published cases of slip-weakening friction.
ContactProblem falling_row() {
    ContactProblem problem;
    problem.grid = {92, 1, 0.1, 200, -4.65, -100};
    const Material steel{82000, 0.28};
    problem.bodies = Bodies::of(MaterialPair{steel, steel});
    Values h;
    for (int ix = 0; ix < 92; ++ix) h.push_back(460 - std::sqrt(460 * 460 - std::pow(problem.grid.x(ix), 2)));
    problem.gap = h;
    problem.Fn = 622216;
    problem.friction = FrictionLaw{{0.3}, KineticFriction{SlipLaw::exponential, 0.18, 100 / std::numbers::ln2}, {}};
    problem.motion = Rolling{.xi = -9.999e-4, .dq = 0.1, .velocity = 45000};
    return problem;
}

bool warns_of(const ContactSolution& solution, const std::string& part) {
    return std::ranges::any_of(solution.warnings,
                               [&](const std::string& one) { return one.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("steady rolling with falling friction has the gain and the force that are published", "[uniqueness]") {
    const ContactProblem problem = falling_row();
    const ContactInfluence bodies = operators_of(problem, pair_table(problem));
    Observer observer;
    const ContactSolution solution = solve_contact(problem, bodies, observer);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fx / (0.3 * 622216), Catch::Matchers::WithinAbs(0.594070, 4e-6));
    CHECK(solution.elements.slip == 36);
    CHECK_THAT(loop_gain(problem, *bodies.current, solution, observer), Catch::Matchers::WithinAbs(0.32, 0.06));
    CHECK_FALSE(warns_of(solution, "Several solutions are possible"));
}

TEST_CASE("the search for several answers can be cancelled", "[uniqueness]") {
    ContactProblem problem = falling_row();
    const ContactInfluence bodies = operators_of(problem, pair_table(problem));
    Observer willing;
    const ContactSolution solution = solve_contact(problem, bodies, willing);
    problem.motion = Shift{{1e-3, 0}};
    class Impatient : public Observer {
        bool cancelled() const override { return true; }
    };
    CHECK_THROWS_AS(loop_gain(problem, *bodies.current, solution, Impatient()), Cancelled);
}

TEST_CASE("a transient step with falling friction warns of several answers", "[uniqueness]") {
    ContactProblem problem = falling_row();
    const ContactSolution steady = solve_half_spaces(problem);
    std::get<Rolling>(problem.motion).kind = RollingKind::transient;
    problem.previous = {steady.pressure, steady.traction_x, steady.traction_y};
    CHECK(warns_of(solve_half_spaces(problem), "Several solutions are possible"));
}

TEST_CASE("a layer that softens steeply warns of several answers", "[uniqueness]") {
    ContactProblem problem = falling_row();
    problem.friction = FrictionLaw{{0.3}, {}, InterfacialLayer{0, 60, -20000}};
    problem.motion = Shift{{0.004, 0}};
    CHECK(warns_of(solve_half_spaces(problem), "Several solutions are possible"));
    problem.friction->layer->hardening = -100;
    CHECK_FALSE(warns_of(solve_half_spaces(problem), "Several solutions are possible"));
}

TEST_CASE("a step in which particles slip farther than they remember warns", "[uniqueness]") {
    ContactProblem problem = falling_row();
    problem.friction->kinetic->memory = FrictionMemory{1e-6, 1};
    CHECK(warns_of(solve_half_spaces(problem), "does not resolve the memory"));
    problem.friction->kinetic->memory->distance = 1;
    CHECK_FALSE(warns_of(solve_half_spaces(problem), "does not resolve the memory"));
}

}  // namespace contactd::test

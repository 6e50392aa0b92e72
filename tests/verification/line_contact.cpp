// Tests plane strain: pressed (Hertz), shifted (Cattaneo and Mindlin) and rolling (Carter) cylinders, and the same in
// anti-plane strain sideways (Johnson, sections 4.2(c), 7.2 and 8.3).
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/contact_cases.hpp"
#include "contactd/solve_contact.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double mu = 0.3, P = 1000, length = 7, radius = 100, datum = 400;
const Material steel{82000, 0.28};
const MaterialPair bodies{steel, steel};
const reference::LineContact cylinder = reference::line_contact(bodies, radius, P);

Ics line_contact_ics(double distance) {
    Ics ics;
    ics.line_contact = LineContactSpec{distance};
    return ics;
}

ContactProblem pressed(int n = 500) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, 1, 2.2 * cylinder.half_width / n, length);
    problem.bodies = Bodies::of(bodies, line_contact_ics(datum));
    problem.gap = Paraboloid{radius, std::numeric_limits<double>::infinity()};
    problem.Fn = P * length;
    return problem;
}

ContactProblem moved(const Motion& motion, int n = 500) {
    ContactProblem problem = pressed(n);
    problem.friction = FrictionLaw{{mu}};
    problem.motion = motion;
    return problem;
}

ContactSolution solved(const ContactProblem& problem) {
    ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK(solution.warnings.empty());
    return solution;
}

/// Returns the displacement below the middle of an elliptic traction of `force` per length and the half-width a.
double middle(double compliance, double force, double a) {
    return compliance * force / std::numbers::pi * (std::log(2 * datum / a) + 0.5);
}

constexpr double in_plane = 2 * (1 - 0.28) / 82000, sideways = 2.0 / 82000;

}  // namespace

TEST_CASE("a cylinder pressed on a plane has Hertz's line contact", "[verification]") {
    const auto solution = solved(pressed());
    CHECK_THAT(solution.pmax, WithinRel(cylinder.pmax, 1e-4));
    CHECK_THAT(solution.area.contact, WithinRel(2 * cylinder.half_width * length, 0.005));
    CHECK_THAT(solution.approach, WithinRel(middle(in_plane, P, cylinder.half_width), 1e-4));
    ContactProblem by_approach = pressed();
    by_approach.Fn.reset();
    by_approach.approach = solution.approach;
    CHECK_THAT(solved(by_approach).forces.Fn, WithinRel(P * length, 1e-6));
}

TEST_CASE("the length that is counted changes forces and nothing else", "[verification]") {
    ContactProblem longer = moved(Rolling{.xi = 5e-4}, 100);
    const auto one = solved(longer);
    longer.grid.dy = 3 * length;
    longer.grid.y0 = -1.5 * length;
    longer.Fn = 3 * P * length;
    const auto three = solved(longer);
    CHECK_THAT(three.forces.Fx, WithinRel(3 * one.forces.Fx, 1e-6));
    CHECK_THAT(three.pmax, WithinRel(one.pmax, 1e-9));
}

TEST_CASE("a cylinder rolls as Carter says, along and, in anti-plane strain, sideways", "[verification]") {
    const bool along = GENERATE(true, false), backwards = GENERATE(false, true);
    const double share = GENERATE(0.1, 0.5, 0.9);
    const double full = mu * cylinder.pmax * (along ? in_plane : sideways);
    Rolling rolling{.chi = backwards ? std::numbers::pi : 0};
    (along ? rolling.xi : rolling.eta) = share * full;
    const auto solution = solved(moved(rolling, 1600));
    const double expected = -mu * P * length * (1 - (1 - share) * (1 - share));
    CHECK_THAT(along ? solution.forces.Fx : solution.forces.Fy, WithinRel(expected, 1e-3));
    // It is due to rounding, up to the solver's limit of zero.
    CHECK_THAT(along ? solution.forces.Fy : solution.forces.Fx, WithinAbs(0, 1e-6 * mu * P * length));
    CHECK_THAT(solution.area.adhesion, WithinRel(2 * (1 - share) * cylinder.half_width * length, 0.03));
}

TEST_CASE("steady rolling does not depend on the datum", "[verification]") {
    ContactProblem problem = moved(Rolling{.xi = 5e-4}, 200);
    const auto near = solved(problem);
    problem.bodies = Bodies::of(bodies, line_contact_ics(1e5));
    CHECK_THAT(solved(problem).forces.Fx, WithinRel(near.forces.Fx, 1e-5));
}

TEST_CASE("a shift under a force is Cattaneo's and Mindlin's in the plane", "[verification]") {
    const bool along = GENERATE(true, false);
    const double share = 0.6, force = share * mu * P;
    Shift shift;
    (along ? shift.force.Fx : shift.force.Fy) = -force * length;
    const auto solution = solved(moved(shift));
    const double c = cylinder.half_width * std::sqrt(1 - share), compliance = along ? in_plane : sideways;
    CHECK_THAT(solution.area.adhesion, WithinRel(2 * c * length, 0.01));
    const double expected =
        middle(compliance, mu * P, cylinder.half_width) - middle(compliance, mu * P * (1 - share), c);
    const auto& motion = std::get<Shift>(*solution.motion);
    CHECK_THAT(along ? motion.rigid_shift.x : motion.rigid_shift.y, WithinRel(expected, 1e-3));
}

TEST_CASE("dissimilar cylinders couple normal and tangential contact", "[verification]") {
    ContactProblem problem = moved(Rolling{.xi = 0.02}, 200);  // more than the extension due to the pressure
    problem.bodies = Bodies::of({{82000, 0.28}, {1000, 0.1}}, line_contact_ics(datum));
    problem.gap = Paraboloid{radius, std::numeric_limits<double>::infinity()};
    problem.Fn = P * length / 100;
    const auto solution = solved(problem);
    REQUIRE(solution.evidence.outer);
    CHECK(solution.evidence.outer->iterations > 1);
    CHECK(solution.forces.Fx < 0);
}

TEST_CASE("a line contact rolls from rest into its steady state", "[verification]") {
    ContactProblem problem = moved(Rolling{.xi = 5e-4}, 60);
    problem.bodies =
        Bodies::of(bodies, line_contact_ics(5));  // the force builds up over a distance that grows with its logarithm
    const auto steady = solved(problem);
    problem.motion = Rolling{.xi = 5e-4, .kind = RollingKind::transient, .steps = 400};
    CHECK_THAT(solved(problem).forces.Fx, WithinRel(steady.forces.Fx, 0.01));
}

// Compares the Cattaneo problem of the paper's section 4, with closed-form coefficients, with an established half-space
// code of the same discretisation.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cstdlib>

#include "contact/contact_cases.hpp"
#include "contactd/solve_contact.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct Row {
    int n;
    double Fn, Fx, pmax, contact_area;
    int adhesion, slip, elements_off;
};

}  // namespace

TEST_CASE("Cattaneo problem agrees with the half-space code", "[verification]") {
    const Row row = GENERATE(Row{10, 9.21043857, 3.22153276, 4.34658684, 2.9952, 16, 36, 0},
                             Row{40, 9.19731113, 3.22211266, 4.38757728, 3.1680, 216, 664, 0},
                             Row{160, 9.19552945, 3.22162302, 4.39029695, 3.1545, 3464, 10556, 8});
    CAPTURE(row.n);
    const ContactProblem problem = cattaneo_problem(row.n);
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fn, WithinRel(row.Fn, 1e-5));
    CHECK_THAT(solution.forces.Fx, WithinRel(-row.Fx, 1e-5));
    CHECK_THAT(solution.forces.Fy, WithinAbs(0, 1e-5 * row.Fx));
    CHECK_THAT(solution.pmax, WithinRel(row.pmax, 1e-5));
    const double rounding = 5e-5;  // of the printed area
    CHECK_THAT(solution.area.contact,
               WithinAbs(row.contact_area, rounding + row.elements_off * problem.grid.element_area()));
    CHECK(std::abs(solution.elements.adhesion - row.adhesion) <= row.elements_off);
    CHECK(std::abs(solution.elements.slip - row.slip) <= row.elements_off);
}

TEST_CASE("lateral tractions vanish in their sum only", "[verification]") {
    const auto solution = solve_half_spaces(cattaneo_problem(40));
    CHECK(largest(solution.traction_y) > 0.005 * largest(solution.traction_x));
    CHECK_THAT(solution.forces.Fy, WithinAbs(0, 1e-6));
}

TEST_CASE("without lateral effects the problem is Cattaneo's", "[verification]") {
    // With nu = 0, x and y are not coupled, so theory and discretisation solve the same problem.
    ContactProblem problem = cattaneo_problem(80);
    problem.bodies = {{200, 0}, {200, 0}};
    const auto hertz = reference::hertz(problem.bodies.materials(), 50, 0.02);
    const double Fx = 0.7 * 0.4 * hertz.Fn;
    const auto cattaneo = reference::cattaneo(problem.bodies.materials(), hertz, 0.4, Fx);
    problem.motion = Shift{{cattaneo.rigid_shift, 0}};
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fx, WithinRel(-Fx, 2e-3));
    const double adhesion_area = std::acos(-1) * cattaneo.adhesion_radius * cattaneo.adhesion_radius;
    CHECK_THAT(solution.area.adhesion, WithinRel(adhesion_area, 2e-2));
}

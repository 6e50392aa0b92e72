// Tests displacements of the surfaces, and the elastic energy stored by tractions.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact_cases.hpp"
#include "contactd/error.hpp"
#include "random_contact.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("Under pressure bodies yield by what the approach leaves no room for", "[contact]") {
    ContactProblem problem = cattaneo_problem(20);
    problem.friction.reset();
    problem.displacements = true;
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    const Values distance = undeformed_distance(problem);
    for (std::size_t i = 0; i < distance.size(); ++i) {
        const double room = distance[i] - solution.approach + solution.displacement_z[i];
        if (solution.pressure[i] > 0)
            CHECK_THAT(room, WithinAbs(0, 1e-5 * solution.approach));
        else
            CHECK(room > -1e-5 * solution.approach);
    }
    // Fn is proportional to the power 3/2 of the approach, so its work is 2/5 of their product (Johnson, section 4.2).
    CHECK_THAT(*solution.elastic_energy, WithinRel(0.4 * solution.forces.Fn * solution.approach, 1e-2));
}

TEST_CASE("Where bodies adhere they shear by the shift", "[contact]") {
    ContactProblem problem = cattaneo_problem(20);
    problem.displacements = true;
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    const auto& shift = std::get<Shift>(problem.motion).rigid_shift;
    for (std::size_t i = 0; i < solution.pressure.size(); ++i)
        if (solution.pressure[i] > 0) {
            CHECK_THAT(solution.displacement_x[i] + shift.x, WithinAbs(solution.slip_x[i], 1e-5 * std::abs(shift.x)));
            CHECK_THAT(solution.displacement_y[i] + shift.y, WithinAbs(solution.slip_y[i], 1e-5 * std::abs(shift.x)));
        }
}

TEST_CASE("Displacements are there where they were asked for", "[contact]") {
    ContactProblem problem = cattaneo_problem(8);
    const auto plain = solve_half_spaces(problem);
    CHECK(plain.displacement_x.empty());
    CHECK(plain.displacement_z.empty());
    CHECK_FALSE(plain.elastic_energy);
    problem.displacements = true;
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.pressure == plain.pressure);
    CHECK(solution.traction_x == plain.traction_x);
    problem.model = Model::hertz;
    CHECK_THROWS_AS(validate(problem), InvalidArgument);
}

#include <catch2/catch_test_macros.hpp>

#include "random_contact.hpp"

using namespace contactd;
using namespace contactd::test;

TEST_CASE("random problems of every kind meet all contact conditions", "[contact]") {
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        const ContactProblem problem = random_contact(seed, 12);
        const ContactSolution solution = solve_half_spaces(problem);
        INFO("seed " << seed);
        REQUIRE(solution.converged());
        CHECK(contact_faults(problem, solution, state_before_last(problem), 1e-4).empty());
    }
}

TEST_CASE("the checks of random problems find what is wrong", "[contact]") {
    const ContactProblem problem = cattaneo_problem(12);
    ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(contact_faults(problem, solution, {}, 1e-4).empty());
    const std::size_t middle = 12 * 6 + 6;
    SECTION("a pressure") {
        solution.pressure[middle] *= 1.01;
    }
    SECTION("a traction in adhesion") {
        solution.traction_x[middle] *= 1.01;
    }
    SECTION("a traction in slip") {
        for (std::size_t i = 0; i < solution.pressure.size(); ++i)
            if (solution.element_division[i] == ElementState::slip) solution.traction_x[i] *= -1;
    }
    SECTION("the approach") {
        solution.approach *= 1.01;
    }
    CHECK_FALSE(contact_faults(problem, solution, {}, 1e-4).empty());
}

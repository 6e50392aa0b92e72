// Contact problems at the edges of what can be asked: no friction, or hardly any, in parts of the contact; steps that
// fail on the way; numbers whose squares leave the range of a double.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <string>

#include "contact_cases.hpp"
#include "contactd/error.hpp"
#include "contactd/solve_contact.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("a step that fails on the way is not forgotten at the end", "[limits]") {
    ContactProblem problem = cattaneo_problem(12);
    problem.tangential_settings.max_iterations = 6;
    problem.friction->motion = Rolling{.xi = 4e-3, .phi = 1e-3, .steady = false};
    REQUIRE_FALSE(solve_half_spaces(problem).converged());
    problem.friction->motion = Rolling{.xi = 4e-3, .phi = 1e-3, .steady = false, .steps = 40};
    const auto marched = solve_half_spaces(problem);
    CHECK_FALSE(marched.converged());
    CHECK(marched.tangential->residual > problem.tangential_settings.tolerance);
    problem.friction->motion = Rolling{.xi = 4e-3, .phi = 1e-3, .steady = false};
    problem.previous = {marched.pressure, marched.traction_x, marched.traction_y};
    problem.initial_traction_x = marched.traction_x;
    problem.initial_traction_y = marched.traction_y;
    CHECK(solve_half_spaces(problem).converged());  // the last step alone is easy
}

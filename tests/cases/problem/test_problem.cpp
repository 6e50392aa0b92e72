// Tests combinations of values that no problem may have.
#include "problem/problem.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <memory>

using namespace contactd;
using namespace contactd::cases;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

TEST_CASE("coefficients from a file are those of elastic bodies", "[contact_files]") {
    const Material steel{82000, 0.28};
    Given given;
    given.digits.tangential = 0;
    given.digits.influence = 9;
    given.digits.material = 1;
    given.materials = MaterialPair{steel, steel};
    given.coefficients = std::make_shared<const GivenIcs>();
    given.area = Grid{4, 4, 0.5, 0.5, -1, -1};
    given.distance = Quadratic{{0.001, 0, 0.001, 0, 0, 0}};
    given.fn = 10;
    given.creep.emplace();
    const auto solve = [](const ContactProblem&) { return 0.0; };
    CHECK_THROWS_MATCHES(problem_of(given, nullptr, solve), NotCovered,
                         MessageMatches(ContainsSubstring("C = 9") && ContainsSubstring("M = 1")));
}

#include <catch2/catch_test_macros.hpp>

#include "random_state.hpp"

using namespace contactd;
using namespace contactd::test;

TEST_CASE("random problems with layers and memory meet their equations", "[contact]") {
    int solved = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        const auto problem = random_state(seed, 12);
        if (!problem) continue;
        const ContactSolution solution = solve_half_spaces(*problem);
        INFO("seed " << seed);
        CHECK(solution.converged());
        CHECK(state_faults(*problem, solution, 1e-4).empty());
        ++solved;
    }
    CHECK(solved > 80);
}

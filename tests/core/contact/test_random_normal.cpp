// Tests random normal contacts with prescribed approach or force; tests/verification/random_normal.cpp runs any number
// of them.
#include <catch2/catch_test_macros.hpp>

#include "contact/normal/normal.hpp"
#include "random_problems.hpp"

using namespace contactd;
using namespace contactd::test;

TEST_CASE("random normal problems satisfy the contact conditions", "[normal][random]") {
    Observer observer;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        const RandomNormal problem = random_normal(seed, 24);
        const PairOperator influence(problem.table, problem.grid.nx, problem.grid.ny);
        NormalSolution solution;
        if (problem.pressure_sum) {
            solution = solve_normal_force(influence, problem.distance, *problem.pressure_sum, {}, {}, observer);
        } else {
            Values gap = problem.distance;
            for (double& h : gap) h -= problem.approach;
            solution = solve_normal(influence, gap, {}, {}, observer);
            solution.approach = problem.approach;
        }
        CHECK(solution.evidence.converged);
        CHECK(normal_faults(problem, solution.pressure, solution.approach, 1e-6) == "");
    }
}

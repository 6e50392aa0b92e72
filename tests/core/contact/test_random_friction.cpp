// Tests random shift problems; tests/verification/random_friction.cpp runs any number of them.
#include <catch2/catch_test_macros.hpp>

#include "random_friction.hpp"

using namespace contactd;
using namespace contactd::test;

TEST_CASE("random shift problems satisfy Coulomb's law", "[tangential][random]") {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        const RandomFriction problem = random_friction(seed, 20);
        const FrictionAnswer answer = solve(problem);
        CHECK(answer.converged());
        CHECK(friction_faults(problem, answer, 1e-4) == "");
    }
}

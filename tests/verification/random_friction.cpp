// Runs random shift problems: random_friction [count] [first seed] [largest size]. Prints those that did not converge
// and those whose solution violates Coulomb's law; the status is 1 when any does.
#include "contact/random_friction.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace contactd;
using namespace contactd::test;

int main(int argc, char** argv) {
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const int count = argument(1, 2000), first = argument(2, 1), largest_size = argument(3, 64);
    int unconverged = 0, wrong = 0;
    double longest = 0;
    for (int seed = first; seed < first + count; ++seed) {
        const RandomFriction problem = random_friction(static_cast<std::uint64_t>(seed), largest_size);
        const auto start = std::chrono::steady_clock::now();
        const FrictionAnswer answer = solve(problem);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        longest = std::max(longest, seconds.count());
        if (!answer.converged()) {
            ++unconverged;
            std::printf("seed %d, %d x %d: not converged, %d iterations, residual %.1e, force %.1e\n", seed,
                        problem.grid.nx, problem.grid.ny, answer.tangential.evidence.iterations,
                        answer.tangential.evidence.residual, answer.force ? answer.force->residual : 0.0);
            continue;
        }
        const std::string faults = friction_faults(problem, answer, 1e-4);
        if (faults.empty()) continue;
        ++wrong;
        std::printf("seed %d, %d x %d: %s\n", seed, problem.grid.nx, problem.grid.ny, faults.c_str());
    }
    std::printf("%d problems: %d not converged, %d wrong, longest solve %.2f s\n", count, unconverged, wrong, longest);
    return wrong == 0 ? 0 : 1;
}

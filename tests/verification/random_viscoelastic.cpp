// Runs random problems of bodies that creep as they roll: random_viscoelastic [count] [first seed] [largest size].
// Prints those that did not converge and those whose solution violates the contact conditions; the status is 1 when any
// does.
#include "contact/viscoelastic/random_viscoelastic.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace contactd;
using namespace contactd::test;

int main(int argc, char** argv) {
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const int count = argument(1, 500), first = argument(2, 1), largest_size = argument(3, 48);
    int unconverged = 0, wrong = 0;
    double longest = 0;
    for (int seed = first; seed < first + count; ++seed) {
        const ContactProblem problem = random_viscoelastic(static_cast<std::uint64_t>(seed), largest_size);
        const auto start = std::chrono::steady_clock::now();
        const ContactSolution solution = solve_half_spaces(problem);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        longest = std::max(longest, seconds.count());
        const auto describe = [&] {
            std::printf("seed %d, %d x %d%s%s: ", seed, problem.grid.nx, problem.grid.ny, problem.Fn ? ", force" : "",
                        problem.bodies.upper == problem.bodies.lower ? "" : ", dissimilar");
        };
        if (!solution.converged()) {
            ++unconverged;
            describe();
            print_unconverged(solution);
            continue;
        }
        const std::string faults = contact_faults(problem, solution, {}, 1e-4);
        if (faults.empty()) continue;
        ++wrong;
        describe();
        std::printf("%s\n", faults.c_str());
    }
    std::printf("%d problems: %d not converged, %d wrong, longest solve %.2f s\n", count, unconverged, wrong, longest);
    return wrong == 0 ? 0 : 1;
}

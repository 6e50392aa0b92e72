// Compares derivatives of random problems with central differences: random_derivatives [count] [first seed] [largest
// size]. Prints those that are off by more than 1e-4 of the largest; the status is 1 when any is.
#include "contact/random_derivatives.hpp"

#include <cstdio>
#include <cstdlib>

using namespace contactd;
using namespace contactd::test;

int main(int argc, char** argv) {
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const int count = argument(1, 200), first = argument(2, 1), largest_size = argument(3, 32);
    int problems = 0, compared = 0, skipped = 0, wrong = 0, missing = 0;
    double largest = 0;
    for (int seed = first; problems < count; ++seed) {
        const ContactProblem problem = differentiable(static_cast<std::uint64_t>(seed), largest_size);
        const ContactSolution solution = solve_half_spaces(problem);
        if (!solution.converged() || solution.elements.contact == 0) continue;
        ++problems;
        if (!solution.derivatives) {
            ++missing;
            std::printf("seed %d: no derivatives: residual %.1e after %d\n", seed,
                        solution.evidence.derivatives->residual, solution.evidence.derivatives->iterations);
            continue;
        }
        const DerivativeCheck check = check_derivatives(problem, solution);
        compared += check.compared;
        skipped += check.skipped;
        largest = std::max(largest, check.error);
        if (check.error <= 1e-4) continue;
        ++wrong;
        const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
        std::printf("seed %d, %d x %d, %d adhere, %d slip, %s, %s, %s: input %d is off by %.1e (%d iterations)\n", seed,
                    problem.grid.nx, problem.grid.ny, solution.elements.adhesion, solution.elements.slip,
                    !problem.friction   ? "dry"
                    : !rolling          ? "shift"
                    : rolling->steady() ? "steady"
                                        : "transient",
                    problem.bodies.upper == problem.bodies.lower ? "alike" : "unlike", problem.Fn ? "Fn" : "approach",
                    check.worst, check.error, solution.evidence.derivatives->iterations);
    }
    std::printf("%d problems, %d inputs compared, %d skipped, %d problems off, %d without, largest error %.1e\n",
                problems, compared, skipped, wrong, missing, largest);
    return wrong + missing == 0 ? 0 : 1;
}

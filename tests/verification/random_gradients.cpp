// Compares gradients of random problems with central differences: random_gradients [count] [first seed] [largest size].
// Prints problems with a gradient that is off by more than 1e-4 of the largest of its output; the status is 1 when any
// is.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "contact/gradients/random_gradients.hpp"

using namespace contactd;
using namespace contactd::test;

int main(int argc, char** argv) {
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const int count = argument(1, 1000), first = argument(2, 1), largest_size = argument(3, 16);
    int problems = 0, compared = 0, skipped = 0, wrong = 0, missing = 0;
    std::vector<double> errors;
    for (int seed = first; problems < count; ++seed) {
        const auto from = static_cast<std::uint64_t>(seed);
        const ContactProblem problem = random_with_gradients(from, largest_size);
        const ContactSolution solution = solve_half_spaces(problem);
        if (!solution.converged() || solution.elements.contact == 0) continue;
        ++problems;
        const std::vector<OutputOf> outputs = random_outputs(problem, from);
        std::vector<Cotangents> cotangents;
        for (const OutputOf& output : outputs) cotangents.push_back(output.cotangents);
        const ContactGradients found = gradients_of(problem, solution, cotangents, inputs_of(problem));
        if (found.outputs.empty()) {
            ++missing;
            std::printf("seed %d: no gradients: residual %.1e after %d\n", seed, found.evidence.residual,
                        found.evidence.iterations);
            continue;
        }
        const GradientCheck check =
            check_gradients(problem, solution, found.outputs, outputs, random_inputs(problem, solution, from));
        compared += check.compared;
        skipped += check.skipped;
        errors.insert(errors.end(), check.errors.begin(), check.errors.end());
        if (check.error <= 1e-4) continue;
        ++wrong;
        std::printf("seed %d, %d x %d: %s is off by %.1e\n", seed, problem.grid.nx, problem.grid.ny,
                    check.worst.c_str(), check.error);
    }
    std::ranges::sort(errors);
    const auto quantile = [&](std::size_t percent) {
        return errors.empty() ? 0 : errors[(errors.size() - 1) * percent / 100];
    };
    std::printf(
        "%d problems, %d inputs compared, %d skipped, %d problems off, %d without; %zu gradients, errors: "
        "median %.1e, 99 %% %.1e, largest %.1e\n",
        problems, compared, skipped, wrong, missing, errors.size(), quantile(50), quantile(99), quantile(100));
    return wrong + missing == 0 ? 0 : 1;
}

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

#include "random_gradients.hpp"

using namespace contactd;
using namespace contactd::test;

TEST_CASE("gradients of random problems are central differences", "[gradients][random]") {
    int problems = 0, compared = 0, skipped = 0;
    std::vector<double> errors;
    for (std::uint64_t seed = 1; problems < 40; ++seed) {
        CAPTURE(seed);
        const ContactProblem problem = random_with_gradients(seed, 12);
        const ContactSolution solution = solve_half_spaces(problem);
        if (!solution.converged() || solution.elements.contact == 0) continue;
        ++problems;
        const std::vector<OutputOf> outputs = random_outputs(problem, seed);
        std::vector<Cotangents> cotangents;
        for (const OutputOf& output : outputs) cotangents.push_back(output.cotangents);
        const ContactGradients found = gradients_of(problem, solution, cotangents, inputs_of(problem));
        if (found.outputs.empty()) continue;
        const GradientCheck check =
            check_gradients(problem, solution, found.outputs, outputs, random_inputs(problem, solution, seed));
        CAPTURE(check.worst);
        CHECK(check.error <= 1e-4);
        compared += check.compared;
        skipped += check.skipped;
        errors.insert(errors.end(), check.errors.begin(), check.errors.end());
    }
    std::ranges::sort(errors);
    CHECK(errors[errors.size() * 99 / 100] <= 1e-6);
    CHECK(compared > 5 * problems);
    CHECK(skipped < compared / 10);
}

// Compares gradients of problems with options of the set-up with central differences.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include "random_gradients.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

void check_against_differences(const ContactProblem& problem, std::vector<InputChange> more = {}) {
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    const std::vector<OutputOf> outputs = random_outputs(problem, 1);
    std::vector<Cotangents> cotangents;
    for (const OutputOf& output : outputs) cotangents.push_back(output.cotangents);
    std::vector<GradientInput> by{GradientInput::gap, GradientInput::mu, GradientInput::rigid_slip};
    const bool steady = std::holds_alternative<Rolling>(problem.motion) && std::get<Rolling>(problem.motion).steady();
    if (!steady) by.push_back(GradientInput::previous);
    if (!problem.regions) by.push_back(GradientInput::materials);
    const ContactGradients found = gradients_of(problem, solution, cotangents, by);
    REQUIRE(found.outputs.size() == outputs.size());
    std::vector<InputChange> inputs = random_inputs(problem, solution, 1);
    if (problem.regions)
        std::erase_if(inputs, [](const InputChange& input) { return input.name == "G" || input.name == "nu"; });
    for (InputChange& input : more) inputs.push_back(std::move(input));
    const GradientCheck check = check_gradients(problem, solution, found.outputs, outputs, inputs);
    CAPTURE(check.worst);
    CHECK(check.compared >= 6);
    CHECK(check.error <= 1e-4);
}

ContactProblem moving(int kind) {
    if (kind == 0) return shifted_patch();
    ContactProblem problem = rolling_steel();
    if (kind == 2) std::get<Rolling>(problem.motion).kind = RollingKind::transient;
    return problem;
}

}  // namespace

TEST_CASE("a sheet between the bodies takes part in gradients", "[gradients]") {
    ContactProblem problem = moving(GENERATE(0, 1));
    problem.sheet_flexibility = 0.1 / problem.bodies.lower.material.G;
    problem.friction->layer = InterfacialLayer{.flexibility = 0.2 / problem.bodies.lower.material.G};
    check_against_differences(problem);
}

TEST_CASE("gradients by the rigid slip of an element are differences", "[gradients]") {
    ContactProblem problem = moving(GENERATE(0, 1, 2));
    const std::size_t n = problem.grid.size(), i = n / 2 + static_cast<std::size_t>(problem.grid.nx) / 2;
    const double size = problem.motion.index() == 0 ? 1e-3 : 1e-4;
    problem.rigid_slip = {random_values(n, 5, -size, size), random_values(n, 6, -size, size)};
    check_against_differences(problem, {{"gap", size, [i](ContactProblem& p, double by) { p.rigid_slip.y[i] += by; },
                                         [i](const Gradient& g) { return g.rigid_slip.y[i]; }}});
}

TEST_CASE("elements without friction take part in gradients", "[gradients]") {
    ContactProblem problem = moving(GENERATE(0, 1, 2));
    problem.friction->mu.assign(problem.grid.size(), 0.3);
    for (std::size_t i = 0; i < problem.grid.size(); i += 3) problem.friction->mu[i] = 0;
    problem.friction->mu[0] = 0.3;
    check_against_differences(problem);
}

TEST_CASE("regions take part in gradients", "[gradients]") {
    ContactProblem problem = moving(GENERATE(0, 1));
    const double half = problem.grid.nx * problem.grid.dx;
    problem.regions = ContactRegions{{{{-half, 0}, {-half, half}}, {{0, half}, {-half, half}}}, {1, 0.7, 0.7, 1}};
    check_against_differences(problem);
}

TEST_CASE("a line contact has gradients without rotation", "[gradients]") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(24, 1, 0.5, 10);
    Ics ics;
    ics.line_contact = LineContactSpec{100};
    problem.bodies = {{{82000, 0.28}, ics}, {{82000, 0.28}, ics}};
    problem.gap = distance_on(problem.grid, [](double x, double) { return x * x / 800; });
    problem.Fn = 8000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 5e-4};
    problem = tight(problem);
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found =
        gradients_of(problem, solution, {output_of(&Cotangents::Fx)}, {GradientInput::gap, GradientInput::mu});
    REQUIRE(found.outputs.size() == 1);
    CHECK(!found.outputs[0].phi);
    const auto force = [&](double xi) {
        ContactProblem other = problem;
        std::get<Rolling>(other.motion).xi = xi;
        return solve_half_spaces(other).forces.Fx;
    };
    const double difference = (force(5e-4 + 1e-9) - force(5e-4 - 1e-9)) / 2e-9;
    CHECK(std::abs(*found.outputs[0].xi - difference) <= 1e-4 * std::abs(difference));
}

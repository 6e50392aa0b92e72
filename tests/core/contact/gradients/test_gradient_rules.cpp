// Tests gradients by sum rules, forward derivatives, prescribed forces and histories.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contactd/error.hpp"
#include "gradient_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double sum_of(const Values& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

Cotangents weights_of_tractions(std::size_t size) {
    Cotangents output;
    output.traction_x = random_values(size, 1);
    output.slip_y = random_values(size, 2);
    output.pressure = random_values(size, 3);
    return output;
}

}  // namespace

TEST_CASE("gradients by all distances are minus that by the approach", "[gradients]") {
    const ContactProblem problem = GENERATE(0, 1, 2) == 0 ? shifted_patch() : rolling_on_softer();
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found =
        gradients_of(problem, solution, {output_of(&Cotangents::Fx), weights_of_tractions(problem.grid.size())},
                     {GradientInput::gap});
    for (const Gradient& gradient : found.outputs)
        CHECK_THAT(sum_of(gradient.gap), WithinRel(-*gradient.approach, 1e-10));
}

TEST_CASE("gradients of forces are the forward derivatives", "[gradients]") {
    ContactProblem problem = GENERATE(0, 1, 2) == 0 ? shifted_patch()
                             : GENERATE(0, 1) == 0  ? rolling_steel()
                                                    : rolling_on_softer();
    problem.derivatives = true;
    if (GENERATE(false, true)) {
        problem.Fn = solve_half_spaces(problem).forces.Fn;
        problem.approach.reset();
    }
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found =
        gradients_of(problem, solution, {output_of(&Cotangents::Fx), output_of(&Cotangents::Mz)}, {GradientInput::mu});
    REQUIRE(found.outputs.size() == 2);
    for (const bool moment : {false, true}) {
        const Gradient& gradient = found.outputs[moment ? 1 : 0];
        const DerivativesOfAnswer& forward = moment ? *solution.derivatives->Mz : *solution.derivatives->Fx;
        const double scale = std::abs(forward.mu.value());
        CHECK_THAT(sum_of(gradient.mu), WithinAbs(*forward.mu, 2e-4 * scale));
        CHECK(gradient.Fn.has_value() == forward.Fn.has_value());
        if (forward.Fn) CHECK_THAT(*gradient.Fn, WithinAbs(*forward.Fn, 1e-4 * scale / solution.forces.Fn));
        if (forward.xi) CHECK_THAT(*gradient.xi, WithinRel(*forward.xi, 2e-4));
        if (forward.phi) CHECK_THAT(*gradient.phi, WithinRel(*forward.phi, 2e-4));
        if (forward.rigid_shift) CHECK_THAT(gradient.rigid_shift->x, WithinRel(forward.rigid_shift->x, 2e-4));
    }
}

TEST_CASE("a prescribed force has the gradient of a constant", "[gradients]") {
    ContactProblem problem = rolling_steel();
    const ContactSolution free = solve_half_spaces(problem);
    std::get<Rolling>(problem.motion).force = {free.forces.Fx, free.forces.Fy};
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found =
        gradients_of(problem, solution, {output_of(&Cotangents::Fx), output_of(&Cotangents::xi)}, all_of_a_step);
    const Gradient &force = found.outputs[0], &creepage = found.outputs[1];
    CHECK_THAT(*force.Fx, WithinRel(1, 1e-12));
    CHECK_THAT(*force.Fy, WithinAbs(0, 1e-12));
    CHECK_THAT(*force.phi, WithinAbs(0, 1e-6));
    CHECK(largest(force.gap) <= 1e-6);
    // The creepage responds to its force as the force to the creepage.
    problem.motion = *solution.motion;
    std::get<Rolling>(problem.motion).force = {};
    const ContactGradients known =
        gradients_of(problem, solution, {output_of(&Cotangents::Fx), output_of(&Cotangents::Fy)}, {});
    const double determinant =
        *known.outputs[0].xi * *known.outputs[1].eta - *known.outputs[0].eta * *known.outputs[1].xi;
    CHECK_THAT(*creepage.Fx, WithinRel(*known.outputs[1].eta / determinant, 1e-6));
    CHECK_THAT(*creepage.Fy, WithinAbs(-*known.outputs[0].eta / determinant, 1e-6 * std::abs(*creepage.Fx)));
}

TEST_CASE("three transient steps are differentiated backwards", "[gradients]") {
    ContactProblem first = rolling_on_softer();
    if (GENERATE(false, true)) first.bodies = {{82000, 0.28}, {82000, 0.28}};
    auto& rolling = std::get<Rolling>(first.motion);
    rolling.kind = RollingKind::transient;
    rolling.dq = GENERATE(0.85, 1.1);
    const auto march = [](ContactProblem step, std::vector<ContactProblem>* problems,
                          std::vector<ContactSolution>* solutions) {
        ContactSolution last;
        for (int k = 0; k < 3; ++k) {
            if (k > 0) step.previous = {last.pressure, last.traction_x, last.traction_y};
            last = solve_half_spaces(step);
            if (problems) problems->push_back(step);
            if (solutions) solutions->push_back(last);
        }
        return last;
    };
    std::vector<ContactProblem> problems;
    std::vector<ContactSolution> solutions;
    march(first, &problems, &solutions);
    Cotangents output = output_of(&Cotangents::Fx);
    double by_xi = 0, by_bump = 0;
    const Values wave = bump(first.grid, 1.1, -0.9, 2);
    for (int k = 2; k >= 0; --k) {
        std::vector<GradientInput> by{GradientInput::gap, GradientInput::previous};
        const ContactGradients found =
            gradients_of(problems[static_cast<std::size_t>(k)], solutions[static_cast<std::size_t>(k)], {output}, by);
        REQUIRE(found.outputs.size() == 1);
        by_xi += *found.outputs[0].xi;
        by_bump += along(found.outputs[0].gap, wave);
        output = {};
        output.pressure = found.outputs[0].previous->pressure;
        output.traction_x = found.outputs[0].previous->traction_x;
        output.traction_y = found.outputs[0].previous->traction_y;
    }
    const auto difference = [&](const auto& change, double step) {
        ContactProblem above = first, below = first;
        change(above, step);
        change(below, -step);
        return (march(above, nullptr, nullptr).forces.Fx - march(below, nullptr, nullptr).forces.Fx) / (2 * step);
    };
    CHECK_THAT(
        by_xi,
        WithinRel(difference([](ContactProblem& p, double by) { std::get<Rolling>(p.motion).xi += by; }, 1e-9), 1e-5));
    CHECK_THAT(by_bump, WithinRel(difference(
                                      [&](ContactProblem& p, double by) {
                                          for (std::size_t i = 0; i < wave.size(); ++i)
                                              std::get<Values>(*p.gap)[i] += by * wave[i];
                                      },
                                      1e-8),
                                  1e-4));
}

TEST_CASE("a body that becomes softer alone couples pressures and slip", "[gradients]") {
    const ContactProblem problem = rolling_steel();
    const ContactSolution solution = solve_half_spaces(problem);
    const Cotangents output = weights_of_tractions(problem.grid.size());
    const auto value = [&](const ContactSolution& s) {
        return along(output.traction_x, s.traction_x) + along(output.slip_y, s.slip_y) +
               along(output.pressure, s.pressure);
    };
    const ContactGradients found = gradients_of(problem, solution, {output}, {GradientInput::materials});
    ContactProblem above = problem, below = problem;
    above.bodies.lower.material.G *= 1.0005;
    below.bodies.lower.material.G *= 0.9995;
    const ContactSolution up = solve_half_spaces(above), down = solve_half_spaces(below);
    REQUIRE(up.element_division == solution.element_division);
    REQUIRE(down.element_division == solution.element_division);
    CHECK_THAT(found.outputs[0].lower->G, WithinRel((value(up) - value(down)) / (0.001 * 82000), 1e-3));
    CHECK(std::abs(found.outputs[0].upper->G - found.outputs[0].lower->G) > 0.01 * std::abs(found.outputs[0].lower->G));
}

TEST_CASE("the losses of all rows are the whole", "[gradients]") {
    const bool rolls = GENERATE(false, true);
    const ContactProblem problem = rolls ? rolling_steel() : shifted_patch();
    const ContactSolution solution = solve_half_spaces(problem);
    Cotangents rows, lower, upper;
    rows.loss_of_rows.assign(static_cast<std::size_t>(problem.grid.ny), 2);
    lower.loss_of_rows = upper.loss_of_rows = Values(rows.loss_of_rows.size());
    for (std::size_t row = 0; row < rows.loss_of_rows.size(); ++row) (row < 6 ? lower : upper).loss_of_rows[row] = 2;
    const ContactGradients found = gradients_of(
        problem, solution,
        {output_of(rolls ? &Cotangents::frictional_power : &Cotangents::frictional_work, 2), rows, lower, upper},
        {GradientInput::gap});
    const double whole = *found.outputs[0].approach;
    CHECK_THAT(*found.outputs[1].approach, WithinRel(whole, 1e-6));
    CHECK_THAT(*found.outputs[2].approach + *found.outputs[3].approach, WithinRel(whole, 1e-4));
    CHECK(std::abs(*found.outputs[2].approach) > 1e-3 * std::abs(whole));
}

TEST_CASE("a tie of the largest pressures is warned of", "[gradients]") {
    ContactProblem problem = pressed_patch();
    problem.gap = Paraboloid{50, 50};
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found =
        gradients_of(problem, solution, {output_of(&Cotangents::pmax)}, {GradientInput::gap});
    REQUIRE(found.warnings.size() == 1);
    CHECK_THAT(found.warnings[0], ContainsSubstring("4 elements") && ContainsSubstring("pressure_norm"));
}

TEST_CASE("without contact there are no gradients", "[gradients]") {
    ContactProblem problem = pressed_patch();
    problem.approach = -0.01;
    const ContactGradients found =
        gradients_of(problem, solve_half_spaces(problem), {output_of(&Cotangents::Fn)}, {GradientInput::gap});
    CHECK(found.outputs.empty());
    REQUIRE(found.warnings.size() == 1);
    CHECK_THAT(found.warnings[0], ContainsSubstring("no contact"));
}

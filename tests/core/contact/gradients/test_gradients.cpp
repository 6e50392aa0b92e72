// Compares gradients with values of an independent dense prototype.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "gradient_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double accuracy = 1e-4;

double largest_of(const Values& values) {
    return largest(values);
}

std::size_t element(const ContactProblem& problem, int iy, int ix) {
    return at(problem.grid, ix, iy);
}

}  // namespace

TEST_CASE("pressures have the gradients of a dense prototype", "[gradients]") {
    const ContactProblem problem = pressed_patch();
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found =
        gradients_of(problem, solution,
                     {output_of(&Cotangents::Fn), output_of(&Cotangents::pmax), output_of(&Cotangents::pressure_norm)},
                     {GradientInput::gap, GradientInput::materials});
    REQUIRE(found.outputs.size() == 3);
    const Gradient& force = found.outputs[0];
    CHECK_THAT(*force.approach, WithinRel(696.2428, accuracy));
    CHECK_THAT(force.upper->G + force.lower->G, WithinRel(0.046025078, accuracy));
    CHECK_THAT(force.upper->nu + force.lower->nu, WithinRel(15.870717, accuracy));
    const Values wave = bump(problem.grid, 0.192, -0.216, 0.36);
    CHECK_THAT(along(force.gap, wave), WithinRel(-51.443853, accuracy));
    CHECK_THAT(force.gap[element(problem, 4, 13)], WithinAbs(-10.601906, accuracy * largest_of(force.gap)));
    CHECK_THAT(found.outputs[1].gap[element(problem, 8, 8)], WithinRel(-2672.9306, accuracy));
    CHECK_THAT(along(found.outputs[2].gap, wave), WithinRel(-146.38771, accuracy));
}

TEST_CASE("a shift has the gradients of a dense prototype", "[gradients]") {
    const ContactProblem problem = shifted_patch();
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found = gradients_of(
        problem, solution, {output_of(&Cotangents::Fx), output_of(&Cotangents::frictional_work)}, all_of_a_step);
    REQUIRE(found.outputs.size() == 2);
    const Gradient& force = found.outputs[0];
    CHECK_THAT(*force.approach, WithinRel(-95.10533, accuracy));
    CHECK_THAT(force.rigid_shift->x, WithinRel(-337.49349, accuracy));
    CHECK_THAT(force.rigid_shift->y, WithinRel(28.748837, accuracy));
    CHECK_THAT(*force.rotation, WithinRel(40.920857, accuracy));
    CHECK_THAT(along(force.gap, bump(problem.grid, 0.192, -0.216, 0.36)), WithinRel(-15.363066, accuracy));
    CHECK_THAT(force.gap[element(problem, 5, 2)], WithinAbs(2.6836738, accuracy * largest_of(force.gap)));
    CHECK_THAT(force.mu[element(problem, 5, 2)], WithinAbs(-0.014723092, accuracy * largest_of(force.mu)));
    CHECK_THAT(found.outputs[1].rigid_shift->x, WithinRel(0.59200833, accuracy));
}

TEST_CASE("steady rolling has the gradients of a dense prototype", "[gradients]") {
    ContactProblem problem = rolling_steel();
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found = gradients_of(
        problem, solution, {output_of(&Cotangents::Fx), output_of(&Cotangents::frictional_power)}, all_of_a_step);
    REQUIRE(found.outputs.size() == 2);
    const Gradient &force = found.outputs[0], &loss = found.outputs[1];
    const Values wave = bump(problem.grid, 1.12, -0.864, 2.1);
    CHECK_THAT(*force.approach, WithinRel(-62989.973, accuracy));
    CHECK_THAT(*force.xi, WithinRel(-4380977, accuracy));
    CHECK_THAT(*force.phi, WithinRel(1339199.6, accuracy));
    CHECK_THAT(along(force.gap, wave), WithinRel(-6194.9818, accuracy));
    CHECK_THAT(force.gap[element(problem, 6, 2)], WithinAbs(5059.3651, accuracy * largest_of(force.gap)));
    CHECK_THAT(force.mu[element(problem, 6, 2)], WithinAbs(-2.2047494, accuracy * largest_of(force.mu)));
    CHECK_THAT(*loss.eta, WithinRel(-3549.7082, accuracy));
    CHECK_THAT(along(loss.gap, wave), WithinRel(13.106055, accuracy));
    CHECK_THAT(loss.upper->G + loss.lower->G, WithinRel(8.8365687e-5, accuracy));

    auto& rolling = std::get<Rolling>(problem.motion);
    rolling.force.Fx = solution.forces.Fx;
    const ContactSolution by_force = solve_half_spaces(problem);
    const ContactGradients held =
        gradients_of(problem, by_force, {output_of(&Cotangents::frictional_power)}, all_of_a_step);
    REQUIRE(held.outputs.size() == 1);
    CHECK_THAT(*held.outputs[0].phi, WithinRel(2656.7844, accuracy));
    CHECK(!held.outputs[0].xi);
    CHECK(held.outputs[0].Fx);
}

TEST_CASE("rolling on a softer body has the gradients of a dense prototype", "[gradients]") {
    const ContactProblem problem = rolling_on_softer();
    const ContactSolution solution = solve_half_spaces(problem);
    const ContactGradients found = gradients_of(
        problem, solution, {output_of(&Cotangents::Fx), output_of(&Cotangents::pressure_norm)}, all_of_a_step);
    REQUIRE(found.outputs.size() == 2);
    const Gradient& force = found.outputs[0];
    CHECK_THAT(*force.approach, WithinRel(-20977.962, accuracy));
    CHECK_THAT(*force.eta, WithinRel(100201.3, accuracy) || WithinAbs(100201.3, accuracy * std::abs(*force.xi)));
    CHECK_THAT(along(force.gap, bump(problem.grid, 1.088, -0.882, 2.04)), WithinRel(-5444.7398, accuracy));
    CHECK_THAT(force.mu[element(problem, 5, 3)], WithinAbs(-38.303313, accuracy * largest_of(force.mu)));
    CHECK_THAT(*found.outputs[1].xi, WithinRel(-1539.716, accuracy));
}

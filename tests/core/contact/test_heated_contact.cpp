// Tests heat of solved contacts: surfaces with their own speeds, layers that shear and flow, friction with memory.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact/friction/temperature_law.hpp"
#include "contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

ContactProblem steel_ellipse(double xi) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(21, 17, 0.6, 0.6);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = Paraboloid{460, 300};
    problem.Fn = 40000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = xi, .velocity = 2e4};
    problem.temperature = ThermalBodies{};
    return problem;
}

double total_heat(const ContactSolution& solution) {
    return solution.temperature->heat_upper + solution.temperature->heat_lower;
}

/// Creates a row of Hertz's pressure over 2 a, in which each element slips by `xi` and is immediately hot.
struct HotRow {
    ContactProblem problem;
    Values pressure;

    HotRow(int n, double xi, const FrictionMemory& memory) {
        constexpr double a = 5;
        problem.grid = Grid::of_elements(n, 1, 2 * a / n, 1);
        problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
        problem.friction = FrictionLaw{{0.4}};
        problem.friction->temperature = TemperatureFriction{-0.25, 1e-6, 1e-9, memory};
        problem.motion = Rolling{.xi = xi, .velocity = 1e4};
        problem.temperature = ThermalBodies{};
        for (int ix = 0; ix < n; ++ix) pressure.push_back(1000 * std::sqrt(1 - std::pow(problem.grid.x(ix) / a, 2)));
    }

    /// Returns the traction over the normal force of Hertz's strip.
    double mean(double slip) const {
        TemperatureLaw law(problem);
        const MotionOfElements motion{Values(pressure.size(), slip * 1e4), {}, {slip}};
        law.follow(motion, pressure);
        double sum = 0;
        for (std::size_t i = 0; i < pressure.size(); ++i) sum += pressure[i] * law.mu()[i];
        return sum * problem.grid.dx / (0.5 * std::numbers::pi * 5 * 1000);
    }
};

}  // namespace

TEST_CASE("A rolling and sliding strip is as warm as Blok's formula", "[temperature][contact]") {
    constexpr double b = 13.290033860, load = 500, mu = 0.1;
    const auto [upper, lower] = GENERATE(std::pair(10.2e3, 9.8e3), std::pair(5e3, 15e3), std::pair(19e3, 1e3));
    ContactProblem problem;
    problem.grid = {120, 1, 0.008, 800, -0.64, -400};
    const Material steel{210e3 / 2.6, 0.3};
    problem.bodies = Bodies::of({steel, steel});
    Values gap(120);
    for (int ix = 0; ix < 120; ++ix) gap[static_cast<std::size_t>(ix)] = std::pow(problem.grid.x(ix), 2) / 40;
    problem.gap = gap;
    problem.Fn = load * 800;
    problem.friction = FrictionLaw{{mu}};
    const double velocity = (upper + lower) / 2;
    problem.motion = Rolling{.xi = (lower - upper) / velocity, .velocity = velocity};
    problem.temperature = ThermalBodies{};
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    const double a = std::sqrt(8 * load * 20 * (1 - 0.09) / (std::numbers::pi * 210e3));
    const double roots = b * (std::sqrt(upper) + std::sqrt(lower));
    CHECK_THAT(solution.temperature->rise,
               WithinRel(1.110 * mu * load * std::abs(upper - lower) / (roots * std::sqrt(2 * a)), 8e-3));
    CHECK_THAT(solution.temperature->heat_upper / total_heat(solution), WithinAbs(b * std::sqrt(upper) / roots, 1e-3));
}

TEST_CASE("The heat of a layer that shears or flows is what friction dissipates", "[temperature][contact]") {
    ContactProblem problem = steel_ellipse(1.1e-3);
    problem.grid = Grid::of_elements(17, 15, 0.65, 0.6);
    problem.Fn = 30000;
    problem.friction->mu = {0.35};
    problem.motion = Rolling{.xi = 1.1e-3, .eta = -7e-4, .phi = 1.5e-4, .velocity = 2e4};
    problem.friction->layer = GENERATE(InterfacialLayer{2e-5}, InterfacialLayer{2e-5, 120, 0},
                                       InterfacialLayer{2e-5, 120, 9000}, InterfacialLayer{2e-5, 120, -4000});
    const ContactSolution all = solve_half_spaces(problem);
    REQUIRE(all.converged());
    CHECK_THAT(total_heat(all), WithinRel(*all.frictional_power, 1e-5));
    const double plastic = all.plastic_power.value_or(0);
    CHECK((plastic > 0) == problem.friction->layer->yields());
    problem.temperature->plastic_share = 0.6;
    const ContactSolution part = solve_half_spaces(problem);
    CHECK(part.traction_x == all.traction_x);
    CHECK_THAT(total_heat(part), WithinRel(*all.frictional_power - 0.4 * plastic, 1e-5));
}

TEST_CASE("Friction follows the heat of a layer that flows", "[temperature][contact]") {
    ContactProblem problem = steel_ellipse(0.01);
    problem.friction->layer =
        InterfacialLayer{.flexibility = 1e-5, .yield_stress = 150, .hardening = GENERATE(0.0, 8000.0)};
    problem.friction->temperature = TemperatureFriction{-0.2, 0, 100};
    problem.temperature->plastic_share = 0.9;
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK(solution.elements.flow > 0);
    for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
        if (!(solution.pressure[i] > 0)) continue;
        const double mu = friction_coefficient(*problem.friction->temperature, 0.3, solution.upper_temperature[i]);
        const double traction = std::hypot(solution.traction_x[i], solution.traction_y[i]);
        CHECK(traction <= mu * solution.pressure[i] * (1 + 1e-4));
        if (solution.element_division[i] == ElementState::slip)
            CHECK_THAT(traction, WithinRel(mu * solution.pressure[i], 1e-4));
    }
}

TEST_CASE("A coefficient with memory follows its temperature over a distance of slip", "[temperature]") {
    constexpr double xi = 0.02, k = 1.5;
    // The closed form .15 + .25 exp(-k) 2 I1(k)/k is .223013129; implicit Euler on n elements gives:
    const auto [n, right] = GENERATE(std::pair(20, 0.223815892), std::pair(40, 0.223295307), std::pair(80, 0.223108833),
                                     std::pair(160, 0.223044234));
    const HotRow row(n, xi, {xi * 5 / k, 0});
    CHECK_THAT(row.mean(xi), WithinRel(right, 1e-7));
}

TEST_CASE("Memory that is short is none, and memory that is long keeps the coefficient", "[temperature][contact]") {
    ContactProblem problem = steel_ellipse(0.02);
    problem.friction->temperature = TemperatureFriction{-0.2, 0, 150};
    const double at_once = solve_half_spaces(problem).forces.Fx;
    problem.friction->temperature->memory = FrictionMemory{1e-9, 1};
    const ContactSolution brief = solve_half_spaces(problem);
    REQUIRE(brief.converged());
    CHECK_THAT(brief.forces.Fx, WithinRel(at_once, 1e-6));
    problem.friction->temperature->memory = FrictionMemory{1e9, 1};
    const double lasting = solve_half_spaces(problem).forces.Fx;
    ContactProblem cold = problem;
    cold.friction->temperature.reset();
    CHECK_THAT(lasting, WithinRel(solve_half_spaces(cold).forces.Fx, 1e-6));
    problem.friction->temperature->memory = FrictionMemory{0.05, 1};
    const ContactSolution between = solve_half_spaces(problem);
    REQUIRE(between.converged());
    CHECK(-between.forces.Fx > -at_once);
    CHECK(-between.forces.Fx < -lasting);
    SECTION("rolling the other way is the mirror image") {
        std::get<Rolling>(problem.motion).chi = std::numbers::pi;
        std::get<Rolling>(problem.motion).xi = -0.02;
        CHECK_THAT(solve_half_spaces(problem).forces.Fx, WithinRel(-between.forces.Fx, 1e-7));
    }
    SECTION("steps of half an element change it little") {
        std::get<Rolling>(problem.motion).dq = 0.3;
        CHECK_THAT(solve_half_spaces(problem).forces.Fx, WithinRel(between.forces.Fx, 2e-2));
    }
}

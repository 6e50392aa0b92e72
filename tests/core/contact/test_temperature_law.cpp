// Tests temperatures of solved contacts, and temperature-dependent friction.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact/friction/temperature_law.hpp"
#include "contact_cases.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Creates a body of a thermal effusivity (N/(mm s^0.5 K)).
ThermalBody body_of(double effusivity, double bulk_temperature = 0) {
    ThermalBody body;
    body.bulk_temperature = bulk_temperature;
    body.conductivity = std::pow(1e3 * effusivity, 2) / (body.density * body.heat_capacity);
    return body;
}

/// Returns the mean slip along x in a row, weighted with the pressure.
double mean_slip(const Grid& grid, const ContactSolution& solution, int row) {
    double sum = 0, weight = 0;
    for (int ix = 0; ix < grid.nx; ++ix) {
        const std::size_t i = at(grid, ix, row);
        sum += solution.pressure[i] * solution.slip_x[i];
        weight += solution.pressure[i];
    }
    return sum / weight;
}

ContactProblem rolling_problem(const Rolling& rolling, double mu) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(21, 17, 0.6, 0.6);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = Paraboloid{460, 300};
    problem.Fn = 40000;
    problem.friction = FrictionLaw{{mu}};
    problem.motion = rolling;
    problem.temperature = ThermalBodies{body_of(13.29), {}};
    problem.settings.tangential.tolerance = problem.settings.outer.tolerance = 1e-9;
    problem.settings.normal.tolerance = 1e-11;
    return problem;
}

/// Creates bodies with their own speeds that become as warm as those of `problem` would if both surfaces passed at the
/// rolling velocity, as in the reference program. All elements slip, and the middle row is the warmest.
ContactProblem as_of_one_speed(ContactProblem problem) {
    const ContactSolution solution = solve_half_spaces(problem);
    const double w = mean_slip(problem.grid, solution, problem.grid.ny / 2);
    const double b = problem.temperature->upper.effusivity() * 2 / (std::sqrt(1 - w / 2) + std::sqrt(1 + w / 2));
    problem.temperature = ThermalBodies{body_of(b), {}};
    return problem;
}

Rolling rolling_of(double xi, double velocity) {
    Rolling rolling;
    rolling.xi = xi;
    rolling.velocity = velocity;
    return rolling;
}

/// Creates friction that decreases from 0.35 by 0.2 between 20 and 170 degrees.
ContactProblem falling_friction() {
    ContactProblem problem = rolling_problem(rolling_of(0.02, 2e4), 0.35);
    problem.friction->temperature = TemperatureFriction{-0.2, 20, 150};
    return problem;
}

double largest_ratio(const ContactSolution& solution, bool smallest = false) {
    double found = smallest ? 1e9 : 0;
    for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
        if (solution.element_division[i] != ElementState::slip) continue;
        const double mu = std::hypot(solution.traction_x[i], solution.traction_y[i]) / solution.pressure[i];
        found = smallest ? std::min(found, mu) : std::max(found, mu);
    }
    return found;
}

std::string refused(const ContactProblem& problem) {
    try {
        validate(problem);
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return "nothing";
}

/// Returns the middle row, from its trailing end.
double in_middle(const std::vector<double>& values, int ix) {
    return values[at(Grid{21, 17}, ix, 8)];
}

}  // namespace

TEST_CASE("Full slip heats the surfaces as is known otherwise", "[temperature][contact]") {
    const ContactSolution solution = solve_half_spaces(as_of_one_speed(rolling_problem(rolling_of(0.01, 2e4), 0.3)));
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fx, WithinRel(-11998.8509, 1e-8));
    CHECK_THAT(*solution.frictional_power, WithinRel(2348.85729e3, 1e-8));
    REQUIRE(solution.temperature);
    CHECK_THAT(solution.temperature->rise, WithinRel(42.443075, 1e-7));
    CHECK_THAT(solution.temperature->heat_upper + solution.temperature->heat_lower,
               WithinRel(*solution.frictional_power, 1e-12));
    int ix = 1;
    CHECK_THAT(in_middle(solution.upper_temperature, ix), WithinRel(35.3888033, 1e-7));
    for (const double right : {41.1217431, 39.4888967, 28.5975487, 15.2314094, 2.45806587}) {
        ix += ix == 1 ? 1 : 4;
        CHECK_THAT(in_middle(solution.upper_temperature, ix), WithinRel(right, 1e-7));
    }
}

TEST_CASE("Bodies that differ in heat and bulk temperature are as warm as is known otherwise",
          "[temperature][contact]") {
    Rolling rolling = rolling_of(0.004, 3e4);
    rolling.eta = 0.002;
    rolling.phi = 2e-4;
    ContactProblem problem = rolling_problem(rolling, 0.35);
    problem.temperature = ThermalBodies{body_of(13.29, 20), body_of(6.5, 140)};
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fx, WithinRel(-12151.3399, 1e-8));
    CHECK_THAT(solution.forces.Fy, WithinRel(-6859.40603, 1e-8));
    CHECK_THAT(*solution.frictional_power, WithinRel(1775.69092e3, 1e-8));
    // The values are for bodies that both pass at the rolling velocity; these pass at their own speeds, in each row by
    // its slip.
    const auto by_speeds = [&](int row, double rise, double warmth = 1) {
        const double w = mean_slip(problem.grid, solution, row);
        const double upper = 13.29 * std::sqrt(1 - w / 2), lower = 6.5 * std::sqrt(1 + w / 2);
        return (warmth * (20 * upper + 140 * lower) + (13.29 + 6.5) * rise) / (upper + lower);
    };
    const int hottest = static_cast<int>(std::lround((solution.temperature->y - problem.grid.y(0)) / problem.grid.dy));
    CHECK_THAT(solution.temperature->rise, WithinRel(by_speeds(hottest, 38.7895558, 0), 1e-7));
    CHECK_THAT(solution.temperature->largest, WithinRel(by_speeds(hottest, 38.7895558), 1e-8));
    CHECK_THAT(by_speeds(hottest, 38.7895558), WithinRel(98.2034012, 1e-3));
    int ix = 2;
    for (const double right : {38.0828249, 33.0428388, 19.39349, 6.89066701, 0.371436359}) {
        CHECK_THAT(in_middle(solution.upper_temperature, ix), WithinRel(by_speeds(8, right), 1e-7));
        CHECK(in_middle(solution.upper_temperature, ix) == in_middle(solution.lower_temperature, ix));
        ix += 4;
    }
}

TEST_CASE("Friction that falls with the temperature is as known otherwise", "[temperature][contact]") {
    const ContactSolution solution = solve_half_spaces(as_of_one_speed(falling_friction()));
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fx, WithinRel(-12368.5752, 1e-8));
    CHECK_THAT(solution.temperature->largest, WithinRel(80.5106825, 1e-8));
    CHECK(solution.elements.slip == 193);
    CHECK_THAT(largest_ratio(solution, true), WithinRel(0.26931909, 1e-7));
    CHECK_THAT(largest_ratio(solution), WithinRel(0.35, 1e-9));
    ContactProblem usual = falling_friction();
    usual.settings = {};
    CHECK(solve_half_spaces(usual).evidence.outer->iterations <= 6);
}

TEST_CASE("A locomotive's wheel slips as is known otherwise", "[temperature][contact]") {
    ContactProblem problem = rolling_problem(rolling_of(-0.03333, 3e4), 0.3);
    std::get<Rolling>(problem.motion).chi = std::numbers::pi;
    problem.grid = {216, 45, 0.2, 0.5, -7.9, -11.25};
    problem.gap = Paraboloid{1 / (2 * 0.001015), 1 / (2 * 0.0004215)};
    problem.Fn = 1e5;
    problem.temperature = ThermalBodies{};
    problem.settings = {};
    SECTION("of constant friction") {
        const ContactSolution solution = solve_half_spaces(as_of_one_speed(problem));
        CHECK_THAT(solution.forces.Fx, WithinRel(29999.6159, 1e-8));
        CHECK_THAT(solution.temperature->rise, WithinRel(152.344084, 1e-7));
    }
    SECTION("of friction that falls") {
        problem.friction->temperature = TemperatureFriction{-0.18, 0, 400};
        const ContactSolution solution = solve_half_spaces(as_of_one_speed(problem));
        REQUIRE(solution.converged());
        CHECK_THAT(solution.forces.Fx, WithinRel(26435.5798, 1e-7));
        CHECK_THAT(solution.temperature->largest, WithinRel(128.424037, 1e-7));
        CHECK(solution.evidence.outer->iterations <= 6);
    }
}

TEST_CASE("Friction follows the temperature that its own heat makes", "[temperature][contact]") {
    Rolling rolling = rolling_of(0.002, 3e4);
    rolling.eta = 0.001;
    rolling.phi = 2e-4;
    for (const double change : {-0.2, 0.1}) {
        ContactProblem problem = rolling_problem(rolling, 0.35);
        problem.friction->temperature = TemperatureFriction{change, 5, 20};
        const ContactSolution solution = solve_half_spaces(problem);
        REQUIRE(solution.converged());
        CHECK(solution.elements.adhesion > 0);
        for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
            if (!(solution.pressure[i] > 0)) continue;
            const double bound = solution.pressure[i] * friction_coefficient(*problem.friction->temperature, 0.35,
                                                                             solution.upper_temperature[i]);
            const double traction = std::hypot(solution.traction_x[i], solution.traction_y[i]);
            if (solution.element_division[i] == ElementState::slip)
                CHECK_THAT(traction, WithinRel(bound, 1e-6));
            else
                CHECK(traction <= bound * (1 + 1e-6));
        }
    }
}

TEST_CASE("Friction that no temperature changes is Coulomb's to the last bit", "[temperature][contact]") {
    ContactProblem problem = falling_friction();
    problem.friction->temperature.reset();
    const ContactSolution constant = solve_half_spaces(problem);
    for (const TemperatureFriction& law : {TemperatureFriction{0, 20, 150}, TemperatureFriction{-0.2, 1e6, 150}}) {
        problem.friction->temperature = law;
        const ContactSolution solution = solve_half_spaces(problem);
        CHECK(solution.converged());
        CHECK(solution.traction_x == constant.traction_x);
        CHECK(solution.upper_temperature == constant.upper_temperature);
    }
}

TEST_CASE("Rolling the other way is the mirror image with friction by temperature, too", "[temperature][contact]") {
    ContactProblem problem = falling_friction();
    const ContactSolution forwards = solve_half_spaces(problem);
    auto& rolling = std::get<Rolling>(problem.motion);
    rolling.chi = std::numbers::pi;
    rolling.xi = -rolling.xi;
    const ContactSolution backwards = solve_half_spaces(problem);
    CHECK_THAT(backwards.forces.Fx, WithinRel(-forwards.forces.Fx, 1e-9));
    CHECK_THAT(backwards.temperature->largest, WithinRel(forwards.temperature->largest, 1e-9));
    CHECK_THAT(backwards.temperature->x, WithinAbs(-forwards.temperature->x, 1e-12));
}

TEST_CASE("The own heat of an element has a temperature in each part of the law", "[temperature]") {
    for (const TemperatureFriction& law : {TemperatureFriction{-0.2, 20, 150}, TemperatureFriction{0.2, 20, 150}})
        for (const double T0 : {-10.0, 15.0, 60.0, 300.0})
            for (const double rise : {0.0, 10.0, 100.0, 700.0}) {
                const double mu = coefficient_of_own_heat(law, 0.3, T0, rise);
                CHECK_THAT(friction_coefficient(law, 0.3, T0 + rise * mu), WithinAbs(mu, 1e-12));
            }
    // If friction increases and has several solutions, the coldest is found.
    CHECK(coefficient_of_own_heat({1, 20, 1}, 0.1, 0, 100) == 0.1);
}

TEST_CASE("Temperatures are refused of what they are not known for, by name", "[temperature][contact]") {
    CHECK(refused(falling_friction()) == "nothing");
    ContactProblem problem = falling_friction();
    problem.temperature.reset();
    CHECK(refused(problem) == "friction.temperature");
    problem.friction->temperature.reset();
    problem.temperature = ThermalBodies{};
    const ContactProblem plain = problem;
    problem.motion = Shift{};
    CHECK(refused(problem) == "temperature");
    problem = plain;
    std::get<Rolling>(problem.motion).kind = RollingKind::transient;
    CHECK(refused(problem) == "friction.rolling.kind");
    problem = plain;
    std::get<Rolling>(problem.motion).chi = 0.5;
    CHECK(refused(problem) == "friction.rolling.chi");
    problem = plain;
    std::get<Rolling>(problem.motion).velocity = 1;
    CHECK(refused(problem) == "friction.rolling.velocity");
    problem = plain;
    problem.model = Model::hertz;
    CHECK(refused(problem) == "model");
    problem = plain;
    problem.friction.reset();
    CHECK(refused(problem) == "temperature");
    CHECK_NOTHROW(validate_opening(problem));
    problem = plain;
    std::get<Ics>(problem.bodies.lower.ics).load_shape = std::get<Ics>(problem.bodies.upper.ics).load_shape =
        LoadShape::bilinear;
    CHECK(refused(problem) == "bodies.upper.ics.load_shape");
    for (const auto& [law, field] : {std::pair(TemperatureFriction{-0.35, 20, 150}, "change"),
                                     std::pair(TemperatureFriction{-0.1, 20, 0}, "range"),
                                     std::pair(TemperatureFriction{-0.1, NAN, 10}, "reference")}) {
        problem = falling_friction();
        problem.friction->temperature = law;
        CHECK(refused(problem) == std::string("friction.temperature.") + field);
    }
    problem = falling_friction();
    problem.friction->kinetic = KineticFriction{SlipLaw::linear, 0.1, 100};
    CHECK(refused(problem) == "friction.temperature");
    problem = falling_friction();
    problem.friction->temperature->memory = FrictionMemory{0, 1};
    CHECK(refused(problem) == "friction.temperature.memory.distance");
    problem.friction->temperature->memory = FrictionMemory{1, -1};
    CHECK(refused(problem) == "friction.temperature.memory.least_velocity");
    problem = falling_friction();
    problem.derivatives = true;
    CHECK(refused(problem) == "derivatives");
}

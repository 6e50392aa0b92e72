// Tests warnings about mistaken units in contact problems, detected by magnitudes.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

bool warns_of(const ContactSolution& solution, const std::string& part) {
    return std::ranges::any_of(solution.warnings,
                               [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

/// Creates rolling steel wheels of radius 460 and 300 mm under 80 kN.
ContactProblem wheels() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(40, 40, 0.6, 0.6);
    problem.bodies = {{80e3, 0.28}, {80e3, 0.28}};
    problem.gap = Paraboloid{460, 300};
    problem.Fn = 80e3;
    problem.friction = FrictionLaw{{0.33}};
    problem.motion = Rolling{.xi = 1e-3, .phi = 1e-4};
    return problem;
}

ContactSolution solve(const ContactProblem& problem) {
    if (problem.model == Model::full) return solve_half_spaces(problem);
    Observer observer;
    return solve_contact(problem, {}, observer);
}

}  // namespace

TEST_CASE("Sound units of wheels make no sentence", "[contact]") {
    ContactProblem problem = wheels();
    problem.model = GENERATE(Model::full, Model::fastsim, Model::fastrip, Model::polach);
    CHECK(solve(problem).warnings.empty());
}

TEST_CASE("Friction that falls with the creepage is not said never to fall", "[contact]") {
    ContactProblem problem = wheels();
    problem.model = GENERATE(Model::full, Model::fastsim, Model::fastrip, Model::polach);
    problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.132, 300.0};
    problem.motion = Rolling{.xi = 0.02, .velocity = 20e3};
    CHECK_FALSE(warns_of(solve(problem), "hardly falls"));
    // The velocity is 0.02 mm/s if it is omitted.
    problem.motion = Rolling{.xi = 0.02};
    const bool of_elements = problem.model != Model::polach;
    CHECK(warns_of(solve(problem), of_elements ? "hardly falls: the largest slip velocity is"
                                               : "hardly falls: the velocity of the creepage (xi, eta) is 0.02 mm/s"));
}

TEST_CASE("Falling friction of Polach's model is not doubted where a force is prescribed", "[contact]") {
    ContactProblem problem = wheels();
    problem.model = Model::polach;
    problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.132, 300.0};
    problem.motion = Rolling{.velocity = 20e3, .force = {.Fx = -8e3}};
    CHECK_FALSE(warns_of(solve(problem), "hardly falls"));
}

TEST_CASE("Creepages in percent and spin in 1/m are warned of", "[contact]") {
    ContactProblem problem = wheels();
    problem.model = GENERATE(Model::full, Model::fastsim);
    problem.motion = Rolling{.xi = 1.5};
    CHECK(warns_of(solve(problem), "friction.rolling.xi is 1.5: the surfaces slide by 150 %"));
    problem.motion = Rolling{.eta = -0.8};
    CHECK(warns_of(solve(problem), "friction.rolling.eta is -0.8"));
    problem.motion = Rolling{.phi = 2};
    CHECK(warns_of(solve(problem), "Give the spin in 1/mm"));
    problem.motion = Rolling{.xi = 0.3, .phi = 0.002};
    CHECK_FALSE(warns_of(solve(problem), "friction.rolling"));
}

TEST_CASE("Creepages of a tenth of a percent's size are warned of at a vehicle's speed, where nothing speaks for them",
          "[contact]") {
    ContactProblem problem = wheels();
    problem.model = GENERATE(Model::full, Model::fastsim);
    problem.motion = Rolling{.xi = 0.2, .velocity = 20e3};
    CHECK(warns_of(solve(problem), "friction.rolling.xi is 0.2: at 20 m/s the surfaces slide at 4 m/s"));
    problem.motion = Rolling{.xi = 0.002, .eta = -0.1, .velocity = 20e3};
    CHECK(warns_of(solve(problem), "friction.rolling.eta is -0.1"));
    // Creates a creep curve, a slow test rig, and a slip law for such creepages.
    for (const Rolling& rolling : {Rolling{.xi = 0.02, .velocity = 20e3}, Rolling{.xi = 0.2, .velocity = 1e3}}) {
        problem.motion = rolling;
        CHECK_FALSE(warns_of(solve(problem), "friction.rolling"));
    }
    problem.motion = Rolling{.xi = 0.2, .velocity = 20e3};
    problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.1, 300.0};
    CHECK_FALSE(warns_of(solve(problem), "friction.rolling"));
}

TEST_CASE("Moduli of steel in Pa, and Young's in place of the shear modulus, are warned of", "[contact]") {
    ContactProblem problem = wheels();
    const auto warned = [&](double G, const std::string& part) {
        problem.bodies.upper.material = problem.bodies.lower.material = Material{G, 0.28};
        return warns_of(solve(problem), part);
    };
    CHECK(warned(210e3, "bodies.upper.G is 210000, Young's modulus of steel in N/mm^2"));
    CHECK(warned(80e9, "a modulus of steel in Pa"));
    CHECK(warned(210e9, "bodies.lower.G is"));
    CHECK_FALSE(warned(80e3, "bodies."));
    // Uses metres, newtons and pascals.
    problem.grid = Grid::of_elements(40, 40, 6e-4, 6e-4);
    problem.gap = Paraboloid{0.46, 0.3};
    problem.motion = Rolling{.xi = 1e-3};
    CHECK_FALSE(warned(80e9, "bodies."));
    CHECK(solve(problem).warnings.empty());
}

TEST_CASE("A load in kN leaves a contact that is lost on its grid, which is said", "[contact]") {
    ContactProblem problem = wheels();
    CHECK_FALSE(warns_of(solve(problem), "Check the units"));
    problem.Fn = 80;
    CHECK(warns_of(solve(problem), "Check the units of forces, lengths and moduli"));
}

TEST_CASE("A coefficient of friction at speed in percent is warned of", "[contact]") {
    ContactProblem problem = wheels();
    problem.friction->mu = {33};
    problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 13, 300.0};
    problem.motion = Rolling{.xi = 0.02, .velocity = 20e3};
    CHECK(warns_of(solve(problem), "friction.mu is up to 33"));
    CHECK(warns_of(solve(problem), "friction.kinetic.mu is up to 13"));
}

TEST_CASE("Heights in micrometres or in metres are warned of, and those in mm are not", "[contact]") {
    ContactProblem problem = wheels();
    problem.friction.reset();
    const Grid& grid = problem.grid;
    std::vector<double> heights;
    SECTION("of a ball") {
        heights = sampled(Paraboloid{460, 300}, grid);
    }
    SECTION("of a rough surface, with waves of 2.4 mm and 20 micrometres") {
        for (int i = 0; i < grid.nx * grid.ny; ++i)
            heights.push_back(0.01 * (2 + std::sin(1.5 * (i % grid.nx)) + std::cos(1.7 * (i / grid.nx))));
    }
    SECTION("of a flat punch with edges") {
        problem.Fn = 8e3;
        for (int i = 0; i < grid.nx * grid.ny; ++i)
            heights.push_back(std::abs(i % grid.nx - 20) < 8 && std::abs(i / grid.nx - 20) < 8 ? 0 : 1e5);
        problem.gap = heights;
        CHECK_FALSE(warns_of(solve(problem), "gap rises"));
        return;
    }
    const auto warned = [&](double unit, const std::string& sentence) {
        std::vector<double> given = heights;
        for (double& height : given) height *= unit;
        problem.gap = given;
        return warns_of(solve(problem), sentence);
    };
    CHECK_FALSE(warned(1, "gap rises"));
    CHECK(warned(1000, "Give heights in mm, not in micrometres."));
    CHECK(warned(1e-3, "all elements are in contact. Give heights in mm, not in m."));
}

TEST_CASE("A gap that is flat is warned of nothing", "[contact]") {
    ContactProblem problem = wheels();
    problem.gap = std::vector<double>(problem.grid.size(), 0);
    CHECK_FALSE(warns_of(solve(problem), "gap rises"));
}

TEST_CASE("Rolling in m/s leaves friction that falls at speed as it is at rest, which is said", "[contact]") {
    ContactProblem problem = wheels();
    problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.132, 300.0};
    problem.motion = Rolling{.xi = 0.01, .velocity = 20};
    CHECK(warns_of(solve(problem), "Friction hardly falls"));
    for (const double xi : {1e-4, 0.01}) {
        problem.motion = Rolling{.xi = xi, .velocity = 20e3};
        CHECK_FALSE(warns_of(solve(problem), "Friction hardly falls"));
    }
}

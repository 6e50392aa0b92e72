// Tests patches whose elements grow if there are too many.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <string>

#include "contactd/error.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr int some = 5000;

/// Creates an overlap of about 20 by 17 mm.
WheelRailSetup heavy(int max_elements) {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.friction = WheelRailFriction{{{0, 0.3}}};
    setup.dx = setup.dy = 0.2;
    setup.patches.max_elements = max_elements;
    return setup;
}

WheelRailState rolling() {
    WheelRailState state;
    state.velocity = {20000, 10, 0, 0, 0, -44.2};
    state.Fz = 80000;
    return state;
}

bool says(const WheelRailSolution& solution, const std::string& part) {
    return std::ranges::any_of(solution.warnings,
                               [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("Patches with too many elements have them twice as long and as wide, and say so") {
    const WheelRailSolution fine = solve(heavy(0), rolling()), coarse = solve(heavy(some), rolling());
    REQUIRE((fine.converged() && coarse.converged()));
    const Grid &finer = fine.patches.at(0).place.grid, &coarser = coarse.patches.at(0).place.grid;
    CHECK(finer.dx == 0.2);
    CHECK(finer.size() > some);
    CHECK(coarser.dx == 0.4);
    CHECK(coarser.dy == 0.4);
    CHECK(coarser.size() < some);
    CHECK_FALSE(says(fine, "max_elements"));
    CHECK(says(coarse, "patches.max_elements"));
    CHECK(std::get<Rolling>(*coarse.patches[0].solution.motion).dq == 0.4);
    CHECK_THAT(coarse.forces.track.Fx, WithinRel(fine.forces.track.Fx, 0.02));
    CHECK_THAT(coarse.patches[0].solution.pmax, WithinRel(fine.patches[0].solution.pmax, 0.02));
}

TEST_CASE("Elements grow as often as it takes, in directions with more than ten of them only") {
    WheelRailSetup setup = heavy(300);
    setup.dy = 2.5;
    const WheelRailSolution solution = solve(setup, rolling());
    const Grid& grid = solution.patches.at(0).place.grid;
    CAPTURE(grid.nx, grid.ny);
    CHECK(grid.dx == 0.8);
    CHECK(grid.dy == 2.5);
}

TEST_CASE("The set-up's step of rolling grows with the elements, and curved contacts have them, too") {
    WheelRailSetup setup = heavy(some);
    setup.dq = 0.1;
    setup.conformal = GENERATE(Conformal::off, Conformal::half_space);
    const WheelRailSolution solution = solve(setup, rolling());
    REQUIRE(solution.converged());
    CHECK(solution.patches.at(0).place.grid.dy == 0.4);
    CHECK(std::get<Rolling>(*solution.patches[0].solution.motion).dq == 0.2);
}

TEST_CASE("Transient patches keep their elements, and sections are not divided otherwise") {
    WheelRailState state = rolling();
    state.motion = WheelRailMotion::transient_rolling;
    CHECK(solve(heavy(some), state).patches.at(0).place.grid.dx == 0.2);
    WheelRailSetup sections = heavy(some);
    sections.conformal = Conformal::fem;
    try {
        validate(sections);
        FAIL("nothing was refused");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "patches.max_elements");
    }
}

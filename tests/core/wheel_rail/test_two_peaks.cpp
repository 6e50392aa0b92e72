// A wheel on two bodies of a rail, the wing and the nose, as on a crossing.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "closed_forms/hertz.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double wing_y = -22, nose_y = 18, wing_radius = 200, nose_radius = 80;  // mm

/// Two arcs under a cylinder of 450 mm, the nose lower by `step`, and a groove between them.
WheelRailSetup on_crossing(double step) {
    WheelRailSetup setup = cylinder_on_arc(300);
    ProfilePoints rail;
    for (double y = -38; y <= 32; y += 0.25) {
        const double from_wing = y - wing_y, from_nose = y - nose_y;
        const double wing = wing_radius - std::sqrt(wing_radius * wing_radius - from_wing * from_wing);
        const double nose = nose_radius - std::sqrt(nose_radius * nose_radius - from_nose * from_nose) + step;
        rail.points.push_back({y, std::min(wing, nose)});
    }
    setup.rail.shape = rail;
    setup.dx = setup.dy = 0.2;
    return setup;
}

HertzContact hertz(const WheelRailSetup& setup, double radius, double approach) {
    return hertz_of_approach({450, radius}, setup.bodies.materials().normal_compliance(), approach);
}

}  // namespace

TEST_CASE("On two peaks a wheel carries its load on both, each by its own depth") {
    const double step = GENERATE(0.0, 0.01, 0.03), Fz = 40000;
    const WheelRailSetup setup = on_crossing(step);
    WheelRailState state;
    state.Fz = Fz;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.converged());
    CHECK(solution.warnings.empty());
    REQUIRE(solution.patches.size() == 2);
    const WheelRailPatch &nose = solution.patches[0], &wing = solution.patches[1];
    CHECK_THAT(nose.place.reference.y, WithinAbs(750 + nose_y, 0.02));
    CHECK_THAT(wing.place.reference.y, WithinAbs(750 + wing_y, 0.02));
    CHECK_THAT(nose.forces.track.Fz + wing.forces.track.Fz, WithinRel(Fz, 1e-6));
    // Patches feel nothing of each other but the height, so each is Hertz's contact at its depth.
    const HertzContact on_wing = hertz(setup, wing_radius, solution.z),
                       on_nose = hertz(setup, nose_radius, solution.z - step);
    CHECK_THAT(wing.forces.track.Fz, WithinRel(on_wing.Fn, 0.01));
    CHECK_THAT(nose.forces.track.Fz, WithinRel(on_nose.Fn, 0.01));
    CHECK_THAT(wing.solution.pmax, WithinRel(on_wing.pmax, 0.01));
    CHECK_THAT(nose.solution.pmax, WithinRel(on_nose.pmax, 0.01));
}

TEST_CASE("A peak that the wheel does not reach carries nothing") {
    const WheelRailSetup setup = on_crossing(0.2);
    WheelRailState state;
    state.Fz = 40000;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.patches.size() == 1);
    CHECK_THAT(solution.patches[0].place.reference.y, WithinAbs(750 + wing_y, 0.02));
    CHECK_THAT(solution.patches[0].solution.pmax, WithinRel(hertz(setup, wing_radius, solution.z).pmax, 0.01));
}

TEST_CASE("Over two peaks the force rises without a jump, and passes from one to the other as the wheel rolls") {
    WheelRailSetup setup = on_crossing(0);
    setup.model = Model::hertz;
    WheelRailState state;
    state.Fz = 40000;
    double before = 1;
    for (const double roll : {-0.0012, -0.0006, 0.0, 0.0006, 0.0012}) {
        state.position.roll = roll;
        const WheelRailSolution solution = solve(setup, state);
        REQUIRE(solution.converged());
        double on_wing = 0;
        for (const WheelRailPatch& patch : solution.patches)
            if (patch.place.reference.y < 750) on_wing += patch.forces.track.Fz / 40000;
        CHECK(on_wing <= before);  // a roll to the right lets the field side down
        before = on_wing;
    }
    CHECK(before < 0.2);
}

// Tests fatigue of wheels and rails: the Manchester benchmark, mirrored left wheels, conformal contacts.
#include <cmath>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contactd/error.hpp"
#include "wheel_rail/manchester.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

WheelRailSetup tired_setup(Side side) {
    WheelRailSetup setup = manchester_setup(side);
    const WearPiece grows{15, 0, 1e-5 / 50}, falls{65, 1e-5, -1e-5 / 110};
    setup.fatigue = FatigueRequest{
        .body = WornBody::upper,
        .strength = FatigueStrength{"rail", "a test", 300, 1 / 3.0, 200},
        .damages = {{"whole life", "a test", {0, 1000}, {{0, 0, 0}, grows, falls}}},
        .passage = {},
    };
    return setup;
}

}  // namespace

TEST_CASE("Wheels of the Manchester benchmark tire the rail as told for their positions") {
    struct Known {
        double y, FI_surf, damage;
    };
    const Known known =
        GENERATE(Known{2, -.105, 0}, Known{4, -.155, 2.70e-6}, Known{6, .033, 6.66e-6}, Known{8, .181, 2.32e-6});
    const WheelRailSolution solution =
        solve(tired_setup(Side::right), manchester_state(manchester_at(Side::right, known.y)));
    REQUIRE(solution.patches.size() == 1);
    const ContactFatigue& fatigue = *solution.patches[0].solution.fatigue;
    CAPTURE(known.y, fatigue.T_gamma);
    // Elements at the border are included completely, so areas of elements of 0.2 mm are 2 % larger than those of 0.05
    // mm.
    CHECK_THAT(*fatigue.FI_surf, WithinAbs(known.FI_surf, 8e-3));
    CHECK_THAT(fatigue.damages.at(0).value, WithinAbs(known.damage, 4e-8));
    CHECK(!fatigue.limit);
}

TEST_CASE("A left wheel tires its rail as the right one that is its mirror image") {
    const WheelRailState right_state = manchester_state(manchester_at(Side::right, 6));
    WheelRailState left_state = right_state;
    left_state.position.y *= -1;
    left_state.position.roll *= -1;
    left_state.position.yaw *= -1;
    WheelRailSetup right_setup = tired_setup(Side::right), left_setup = tired_setup(Side::left);
    right_setup.dx = right_setup.dy = left_setup.dx = left_setup.dy = 0.5;
    right_setup.fatigue->passage = left_setup.fatigue->passage = Passage{{0, 0.5, 1, 2}, {}};
    const WheelRailSolution right = solve(right_setup, right_state), left = solve(left_setup, left_state);
    const ContactFatigue &r = *right.patches.at(0).solution.fatigue, &l = *left.patches.at(0).solution.fatigue;
    CHECK(l.limit == r.limit);
    CHECK(l.dang_van->value == r.dang_van->value);
    CHECK(l.shear->y == 0 - r.shear->y);
    CHECK(l.force_angle == 0 - r.force_angle);
    REQUIRE(l.rows.size() == r.rows.size());
    for (std::size_t i = 0; i < r.rows.size(); ++i) {
        FatigueRow mirrored = r.rows[r.rows.size() - 1 - i];
        for (double FatigueRow::* value : {&FatigueRow::y, &FatigueRow::angle, &FatigueRow::force_y})
            mirrored.*value = 0 - mirrored.*value;
        CHECK(l.rows[i] == mirrored);
    }
}

TEST_CASE("A conformal contact has stresses below each of its rows, by its own angle") {
    WheelRailSetup setup = tired_setup(Side::right);
    setup.dx = setup.dy = 0.5;
    setup.conformal = Conformal::half_space;
    setup.fatigue->passage = Passage{};
    const WheelRailState state = manchester_state(manchester_at(Side::right, 6));
    setup.rigid_slip = RigidSlipKind::surfaces;
    const WheelRailSolution conformal = solve(setup, state);
    setup.conformal = Conformal::off;
    setup.rigid_slip = RigidSlipKind{};
    const WheelRailSolution planar = solve(setup, state);
    const WheelRailPatch& patch = conformal.patches.at(0);
    REQUIRE_FALSE(patch.place.rows.empty());
    const ContactFatigue &of_rows = *patch.solution.fatigue, &of_plane = *planar.patches.at(0).solution.fatigue;
    CHECK(of_rows.rows.front().angle != of_rows.rows.back().angle);
    CHECK_THAT(*of_rows.limit, WithinRel(*of_plane.limit, 0.2));
    CHECK_THAT(of_rows.dang_van->value / patch.solution.pmax,
               WithinRel(of_plane.dang_van->value / planar.patches[0].solution.pmax, 0.2));
    CHECK(of_rows.utilisation == of_rows.dang_van->value / 200);
}

TEST_CASE("Fatigue of a wheel in transient rolling is refused") {
    WheelRailState state = manchester_state(manchester_at(Side::right, 2));
    state.motion = WheelRailMotion::transient_rolling;
    state.time_step = 1e-4;
    CHECK_THROWS_AS(solve(tired_setup(Side::right), state), InvalidArgument);
}

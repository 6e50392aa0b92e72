// Values of a wheel on a rail that the program has, too: large rollers, and half-spaces that turn by their variants.
#include <cmath>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "client/cntc/rail_calls.hpp"
#include "contactd/solve_wheel_rail.hpp"

using namespace contactd;
using namespace contactd::cntc::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using contactd::test::manchester_cases;
using contactd::test::ManchesterCase;

namespace {

const ManchesterCase& known_case(Side side, int number) {
    return *std::ranges::find_if(
        manchester_cases, [&](const ManchesterCase& known) { return known.side == side && known.number == number; });
}

}  // namespace

TEST_CASE("a roller of a kilometre is the rail") {
    const Side side = GENERATE(Side::left, Side::right);
    const ManchesterCase& known = known_case(side, 5);
    constexpr double radius = 1e6;
    RailCase rail = manchester_wheel(1, side), roller = manchester_wheel(2, side);
    for (RailCase* one : {&rail, &roller}) place(*one, known);
    const double y = side == Side::left ? -760.532353 : 760.532353;
    roller.whole.flag(1967, side == Side::left ? 4 : 5);
    roller.track(1, {0, y, -0.000023, 0, radius});
    roller.velocity(2, {2000 / radius, 0, 0, 0, 0, known.pitch_rate});
    REQUIRE(rail.whole.calculate() == 0);
    REQUIRE(roller.whole.calculate() == 0);

    const ContactForces on_rail = rail.patch(1).forces(), on_roller = roller.patch(1).forces();
    CHECK_THAT(on_roller.fn, WithinRel(on_rail.fn, 1e-4));
    CHECK_THAT(on_roller.fx, WithinAbs(on_rail.fx, 1e-3 * 0.3 * on_rail.fn));
    CHECK_THAT(on_roller.fy, WithinAbs(on_rail.fy, 1e-3 * 0.3 * on_rail.fn));
    CHECK_THAT(roller.patch(1).max_pressure(), WithinRel(rail.patch(1).max_pressure(), 2e-3));
}

TEST_CASE("half-spaces turn by the variant that the flag asks for") {
    const ManchesterCase& known = known_case(Side::right, 19);
    const int variant = GENERATE(3, 4);
    RailCase rail = manchester_wheel(1, Side::right);
    place(rail, known);
    CHECK(rail.whole.get_flag(1990) == 4);
    rail.whole.flag(1977, 4);
    rail.whole.flag(1978, 4);
    rail.whole.flag(1990, variant);
    CHECK(rail.whole.get_flag(1990) == variant);
    REQUIRE(rail.whole.calculate() == 0);

    WheelRailSetup setup = contactd::test::manchester_setup(Side::right);
    setup.rail = spec_of(ProfileKind::rail, rail_60e1());
    setup.wheel = spec_of(ProfileKind::wheel, s1002());
    setup.rigid_slip = RigidSlipKind::elements;
    setup.conformal = variant == 3 ? Conformal::rotated_displacements : Conformal::rotated;
    Observer observer;
    const auto expected = WheelRailContact(setup).solve(contactd::test::manchester_state(known), observer);
    CHECK_THAT(rail.patch(1).max_pressure(), WithinRel(expected.patches.front().solution.pmax, 1e-6));
    CHECK_THAT(rail.global_forces()[1], WithinRel(expected.forces.track.Fy, 1e-5));
}

TEST_CASE("half-spaces that turn with their loads are refused where they are asked for") {
    RailCase rail = manchester_wheel(1, Side::right);
    place(rail, known_case(Side::right, 5));
    const int variant = GENERATE(1, 2);
    rail.whole.flag(1990, variant);
    CHECK(last_code() == 0);
    REQUIRE(rail.whole.calculate() == 0);  // nothing turns
    rail.whole.flag(1977, 4);
    rail.whole.flag(1978, 4);
    CHECK(rail.whole.calculate() == -99);
    CHECK_THAT(last_sentence(),
               ContainsSubstring("VARIANT = " + std::to_string(variant) + " (flag 1990) is not supported with C = 4"));
    rail.whole.flag(1990, 5);
    CHECK(last_code() == -39);
}

TEST_CASE("distances and angles of patches that are zero part all that can be parted") {
    const ManchesterCase& known = known_case(Side::right, 5);
    RailCase rail = manchester_wheel(1, Side::right), parted = manchester_wheel(2, Side::right);
    for (RailCase* one : {&rail, &parted}) place(*one, known);
    parted.whole.potential(-1, {0.2, 0.2, 0, 0, 0, 0});
    CHECK(last_code() == 0);
    REQUIRE(rail.whole.calculate() == 0);
    REQUIRE(parted.whole.calculate() == 0);
    CHECK(parted.patch(1).forces() == rail.patch(1).forces());  // one region is one patch by all rules
    parted.whole.potential(-1, {0.2, 0.2, 1, 8, -4, 12});
    CHECK(last_code() == -34);
}

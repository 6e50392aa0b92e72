#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "contactd/wheelset_contacts.hpp"
#include "wheel_rail/manchester.hpp"
#include "wheel_rail/position/rising_search.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const WheelRailContact& wheel(Side side) {
    static const WheelRailContact left(manchester_setup(Side::left)), right(manchester_setup(Side::right));
    return side == Side::left ? left : right;
}

WheelsetState wheelset_state(const ManchesterCase& known) {
    WheelsetState state;
    state.position = {known.y, 0, 0, known.yaw};
    state.velocity = {2000, 0, 0, 0, 0, known.pitch_rate};
    state.Fz_left = state.Fz_right = 10000;
    return state;
}

}  // namespace

TEST_CASE("A wheelset that is free to roll has the roll of the Manchester benchmark") {
    const ManchesterCase& known = GENERATE(from_range(std::begin(manchester_cases), std::end(manchester_cases)));
    if (known.side == Side::left) return;  // both have the same roll
    Observer observer;
    const WheelsetSolution solution =
        solve_wheelset(wheel(Side::left), wheel(Side::right), wheelset_state(known), observer);
    INFO("case " << known.number);
    CHECK(solution.converged());
    CHECK_THAT(solution.roll, WithinAbs(known.roll, 3e-6));  // an error of 1e-3 mm in height is 1.3e-6 rad
    CHECK_THAT(solution.left.z, WithinAbs(solution.right.z, 1e-6));
    CHECK_THAT(solution.left.forces.track.Fz, WithinAbs(10000, 0.01));
    CHECK_THAT(solution.right.forces.track.Fz, WithinAbs(10000, 0.01));
}

TEST_CASE("A wheelset in the middle does not roll, and unlike loads press it down by elasticity only") {
    ManchesterCase middle = manchester_cases[0];
    Observer observer;
    WheelsetState state = wheelset_state(middle);
    CHECK(solve_wheelset(wheel(Side::left), wheel(Side::right), state, observer).roll == 0);
    state.Fz_right = 20000;
    const double roll = solve_wheelset(wheel(Side::left), wheel(Side::right), state, observer).roll;
    CHECK(roll > 0);
    CHECK(roll < 0.03 / 1500);
}

TEST_CASE("The axle of unequal wheels leans towards the smaller one, as rigid ones do") {
    WheelsetSetup wheelset;
    WheelRailSetup& setup = wheelset.setup;
    setup.wheel.shape = ConeProfile{-0.05, -60, 60};
    setup.rail.shape = ArcProfile{300, 0, -36, 36};
    setup.track.rail_origin = {750, 0};
    setup.dx = setup.dy = 0.4;
    wheelset.left = setup;
    wheelset.left->wheelset.nominal_radius = 459;
    const WheelRailContact left(setup_of(wheelset, Side::left)), right(setup_of(wheelset, Side::right));
    WheelsetState state;
    state.Fz_left = state.Fz_right = 80e3;
    Observer observer;
    const WheelsetSolution solution = solve_wheelset(left, right, state, observer);
    CHECK(solution.roll_search.converged);
    const auto curve = [](const ProfileSpec& profile) { return make_profile(profile).curve; };
    WheelsetOnTrack rigid = wheelset_on_track(curve(setup.wheel), curve(setup.rail), setup.track, setup.wheelset);
    rigid.left.nominal_radius = 459;
    CHECK_THAT(solution.roll, WithinRel(contacts_at(rigid, 0).roll, 5e-3));
    CHECK_THAT(solution.left.z - solution.right.z, WithinAbs(-1, 1e-6));  // each relative to its own radius
    CHECK_THAT(solution.z, WithinAbs((solution.left.z + solution.right.z) / 2, 1e-12));
}

TEST_CASE("A wheelset does not run on a rail and a roller") {
    WheelRailSetup setup = manchester_setup(Side::left);
    setup.track.roller_radius = 500;
    Observer observer;
    const WheelRailContact left(setup);
    CHECK_THROWS_WITH(solve_wheelset(left, wheel(Side::right), wheelset_state(manchester_cases[0]), observer),
                      ContainsSubstring("left.track.roller_radius is given, but the right wheel runs on a rail"));
}

TEST_CASE("What is wrong with one wheel of a wheelset is named by its side") {
    WheelRailSetup setup = manchester_setup(Side::left);
    setup.dx = setup.dy = 1e-4;
    Observer observer;
    const WheelRailContact left(setup);
    CHECK_THROWS_WITH(solve_wheelset(left, wheel(Side::right), wheelset_state(manchester_cases[0]), observer),
                      StartsWith("left.patches.locus_step times dy"));
}

TEST_CASE("Wheels of the wrong side, and wheels that do not press, are refused") {
    Observer observer;
    WheelsetState state = wheelset_state(manchester_cases[0]);
    CHECK_THROWS_WITH(solve_wheelset(wheel(Side::right), wheel(Side::right), state, observer),
                      ContainsSubstring("left is the contact of a right wheel"));
    state.Fz_left = 0;
    CHECK_THROWS_WITH(solve_wheelset(wheel(Side::left), wheel(Side::right), state, observer),
                      ContainsSubstring("Fz_left is 0"));
}

TEST_CASE("A state of a wheelset is checked by field") {
    const auto [change, sentence] = GENERATE(table<void (*)(WheelsetState&), std::string>({
        {[](WheelsetState& state) { state.left_rail.roll = 2; }, "left_rail.roll is 2"},
        {[](WheelsetState& state) { state.right_rail.y = std::nan(""); }, "right_rail.y is nan"},
        {[](WheelsetState& state) { state.Fz_right = -1; }, "Fz_right is -1"},
        {[](WheelsetState& state) { state.velocity.yaw = 1e300 * 1e300; }, "velocity.yaw is inf"},
    }));
    WheelsetState state = wheelset_state(manchester_cases[0]);
    validate(state);
    change(state);
    CHECK_THROWS_WITH(validate(state), ContainsSubstring(sentence));
}

TEST_CASE("The wheels of a wheelset have what is theirs") {
    WheelsetSetup wheelset{manchester_setup(Side::left)};
    CHECK(setup_of(wheelset, Side::right).side == Side::right);
    CHECK(setup_of(wheelset, Side::left) == manchester_setup(Side::left));
    wheelset.left = manchester_setup(Side::right);
    wheelset.left->dx = 0.7;
    CHECK(setup_of(wheelset, Side::left).dx == 0.7);
    CHECK(setup_of(wheelset, Side::left).side == Side::left);
    CHECK(setup_of(wheelset, Side::right) == manchester_setup(Side::right));
    WheelsetState state = wheelset_state(manchester_cases[0]);
    state.left_rail.y = 1;
    state.Fz_right = 20000;
    CHECK(state_of_left_wheel(state).rail.y == 1);
    CHECK(state_of_right_wheel(state).rail.y == 0);
    CHECK(state_of_right_wheel(state).Fz == 20000);
}

TEST_CASE("A wheelset beside its track carries no load, and says so") {
    Observer observer;
    WheelsetState state = wheelset_state(manchester_cases[0]);
    state.position.y = GENERATE(80, 200);
    const WheelsetSolution solution = solve_wheelset(wheel(Side::left), wheel(Side::right), state, observer);
    CHECK_FALSE(solution.converged());
    REQUIRE_FALSE(solution.warnings.empty());
    CHECK_THAT(solution.warnings.back(), ContainsSubstring("The left wheel does not carry its load"));
    CHECK(std::isfinite(solution.roll_search.residual));
    CHECK(std::isfinite(solution.z));
}

// The established program computes -4.3442191 rad/s in case 5, right wheel.
TEST_CASE("A wheelset that goes on from its last step has the answer of one from nothing, for fewer solves") {
    Observer observer;
    WheelsetEstimates estimates;
    WheelsetState state = wheelset_state(manchester_cases[4]);
    int with = 0, without = 0;
    for (int k = 0; k < 5; ++k) {
        state.position.y += 0.02;
        const WheelsetSolution one = solve_wheelset(wheel(Side::left), wheel(Side::right), state, estimates, observer);
        const WheelsetSolution other = solve_wheelset(wheel(Side::left), wheel(Side::right), state, observer);
        REQUIRE(one.converged());
        CHECK_THAT(one.roll, WithinAbs(other.roll, 2e-9));
        CHECK_THAT(one.left.forces.track.Fy, WithinAbs(other.left.forces.track.Fy, 0.1));
        CHECK_THAT(one.right.forces.track.Fz, WithinAbs(10000, 0.0101));
        if (k == 0) continue;
        with += one.roll_search.iterations;
        without += other.roll_search.iterations;
    }
    CHECK(with <= without);
}

TEST_CASE("A longitudinal force finds the pitch rate that brings it") {
    Observer observer;
    for (const ManchesterCase& known : manchester_cases) {
        if (known.side == Side::left || known.number != 5) continue;
        WheelRailState state = manchester_state(known);
        state.Fx = -300;
        const WheelRailSolution solution = wheel(Side::right).solve(state, observer);
        CHECK(solution.converged());
        CHECK_THAT(solution.pitch_rate, WithinAbs(-4.3442191, 2e-6));
        CHECK_THAT(solution.forces.wheelset.Fx, WithinAbs(-300, 0.01));
        state.velocity.pitch = solution.pitch_rate;
        state.Fx.reset();
        CHECK_THAT(wheel(Side::right).solve(state, observer).forces.wheelset.Fx, WithinAbs(-300, 0.02));
    }
}

TEST_CASE("The first of many steps under a longitudinal force is that of one, to the last bit") {
    Observer observer;
    WheelRailState state = manchester_state(manchester_cases[2]);
    state.Fx = 500;
    WheelRailEstimates estimates;
    const WheelRailSolution first = wheel(Side::left).solve(state, estimates, observer);
    const WheelRailSolution alone = wheel(Side::left).solve(state, observer);
    REQUIRE(alone.converged());
    CHECK(first.pitch_rate == alone.pitch_rate);
    CHECK(first.z == alone.z);
    CHECK(first.forces.track == alone.forces.track);
    CHECK(first.force.value().iterations == alone.force.value().iterations);
}

TEST_CASE("A longitudinal force beyond friction is an answer that has not converged, with a word about it") {
    Observer observer;
    WheelRailState state = manchester_state(manchester_cases[2]);
    state.Fx = -5000;
    const WheelRailSolution solution = wheel(Side::left).solve(state, observer);
    CHECK_FALSE(solution.converged());
    REQUIRE_FALSE(solution.warnings.empty());
    CHECK_THAT(solution.warnings.back(), ContainsSubstring("No pitch rate produces Fx = -5000 N"));
    state.velocity.x = 0;
    CHECK_THROWS_AS(wheel(Side::left).solve(state, observer), InvalidArgument);
}

TEST_CASE("A rising function is searched within its limits") {
    RisingTask task{[](double x) { return std::atan(50 * (x - 0.7)); }, 0, 1e-3, -5, 5, 1e-10, 60};
    CHECK_THAT(find_rising(task).at, WithinAbs(0.7, 1e-9));
    task.high = 0.5;
    const RisingFound beyond = find_rising(task);
    CHECK_FALSE(beyond.converged);
    CHECK(beyond.at == 0.5);
    task.high = 5;
    task.function = [](double x) { return x < 0.7 ? -1.0 : 1.0; };
    CHECK_FALSE(find_rising(task).converged);
}

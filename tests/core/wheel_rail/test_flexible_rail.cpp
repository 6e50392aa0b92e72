// Massless flexible rails.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>
#include <optional>

#include "closed_forms/hertz.hpp"
#include "contactd/error.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Uses S1002 on 60E1, with elements of half a millimetre.
WheelRailSetup on_flexible_rail(std::optional<double> y, std::optional<double> z) {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.track.springs = {y, z};
    return setup;
}

/// Moves the wheel across the track, under a force.
WheelRailState under_force(double y) {
    WheelRailState state;
    state.position = {y, 0, 0.0005, 0.008};
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 80000;
    return state;
}

/// The wheel is at the height with the same force on a fixed rail.
WheelRailState at_height(double y) {
    WheelRailState state = under_force(y);
    WheelRailSetup setup = on_flexible_rail({}, {});
    setup.track.springs.reset();
    state.position.z = solve(setup, state).z;
    state.Fz.reset();
    return state;
}

void check_same_forces(const Wrench& a, const Wrench& b, double part) {
    for (double Wrench::* of : {&Wrench::Fx, &Wrench::Fy, &Wrench::Fz})
        CHECK_THAT(a.*of, WithinAbs(b.*of, part * b.Fz));
}

/// Checks the balance of the rail's springs with all other forces on it.
void check_balance(const WheelRailSetup& setup, const WheelRailState& state, const WheelRailSolution& solution) {
    REQUIRE(solution.converged());
    REQUIRE(solution.rail_deflection);
    REQUIRE(solution.rail_search);
    const auto& [y, z] = *setup.track.springs;
    const Wrench& wheel = solution.forces.track;
    const double off_y = y ? wheel.Fy + state.rail.Fy - *y * solution.rail_deflection->y : solution.rail_deflection->y;
    const double off_z = z ? wheel.Fz + state.rail.Fz - *z * solution.rail_deflection->z : solution.rail_deflection->z;
    const double largest = std::max(std::abs(off_y), std::abs(off_z));
    CHECK(largest <= setup.force.tolerance * wheel.Fz * (1 + 1e-9));
    CHECK_THAT(solution.rail_search->residual, WithinAbs(largest / wheel.Fz, 1e-12));
    CHECK(solution.rail_search->iterations >= 1);
}

}  // namespace

TEST_CASE("The forces on a flexible rail are in balance") {
    WheelRailSetup setup =
        on_flexible_rail(GENERATE(std::optional<double>{}, 3e3, 2e4), GENERATE(std::optional(3e4), 5e5));
    setup.model = GENERATE(Model::full, Model::fastsim);
    const double y = GENERATE(0.0, 7.5);
    WheelRailState state = under_force(y);
    SECTION("under a force") {}
    SECTION("at a height") {
        state = at_height(y);
    }
    if (setup.track.springs->y) state.rail.Fy = -1500;
    state.rail.Fz = -4000;
    check_balance(setup, state, solve(setup, state));
}

TEST_CASE("A flexible rail is one that lies where it has deflected to") {
    const WheelRailSetup setup = on_flexible_rail(5e3, 5e4);
    const WheelRailState state = GENERATE(0, 1) == 0 ? under_force(7.2) : at_height(7.2);
    const WheelRailSolution deflected = solve(setup, state);
    check_balance(setup, state, deflected);
    CHECK(std::abs(deflected.rail_deflection->y) > 0.1);
    WheelRailSetup rigid = setup;
    rigid.track.springs.reset();
    WheelRailState there = state;
    there.rail.y += deflected.rail_deflection->y;
    there.rail.z += deflected.rail_deflection->z;
    const WheelRailSolution fixed = solve(rigid, there);
    CHECK_THAT(deflected.z, WithinAbs(fixed.z, 1e-6));
    check_same_forces(deflected.forces.track, fixed.forces.track, 1e-5);
    REQUIRE(fixed.patches.size() == deflected.patches.size());
    CHECK_THAT(deflected.patches[0].place.reference.y, WithinAbs(fixed.patches[0].place.reference.y, 1e-3));
    CHECK_THAT(deflected.forces.track.Mx, WithinRel(fixed.forces.track.Mx, 1e-5));
}

TEST_CASE("Stiff springs hold a rail") {
    WheelRailSetup setup = on_flexible_rail(1e10, 1e10);
    const double y = GENERATE(0.0, 7.5);
    const WheelRailState state = GENERATE(0, 1) == 0 ? under_force(y) : at_height(y);
    const WheelRailSolution stiff = solve(setup, state);
    check_balance(setup, state, stiff);
    setup.track.springs.reset();
    const WheelRailSolution rigid = solve(setup, state);
    check_same_forces(stiff.forces.track, rigid.forces.track, 5e-4);
    CHECK_THAT(stiff.z, WithinAbs(rigid.z, 1e-3));
    CHECK_FALSE(rigid.rail_deflection);
    CHECK_FALSE(rigid.rail_search);
}

TEST_CASE("A contact and a spring deflect in series") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.model = Model::hertz;
    const double stiffness = GENERATE(1e4, 1e6), load = GENERATE(0.0, 3000.0), Fn = 60000;
    setup.track.springs = RailSprings{{}, stiffness};
    const HertzContact known = hertz_of_force({450, 300}, setup.bodies.materials().normal_compliance(), Fn);
    WheelRailState state;
    state.rail.Fz = load;
    state.position.z = known.approach + (Fn + load) / stiffness;
    state.derivatives = true;
    const WheelRailSolution solution = solve(setup, state);
    // The ellipse that represents the overlap is found on rows of elements.
    CHECK_THAT(solution.forces.track.Fz, WithinRel(Fn, 2e-3));
    CHECK_THAT(solution.rail_deflection.value().z, WithinRel((solution.forces.track.Fz + load) / stiffness, 1e-6));
    const double of_contact = 1.5 * Fn / known.approach;
    REQUIRE(solution.derivatives);
    CHECK_THAT(solution.derivatives->position.z.Fz, WithinRel(stiffness * of_contact / (stiffness + of_contact), 0.01));
}

TEST_CASE("Forces on a flexible rail follow position and motion as their derivatives say") {
    WheelRailSetup setup = on_flexible_rail(GENERATE(std::optional(2e4), std::optional<double>{}), 1e5);
    setup.dx = setup.dy = 0.4;
    WheelRailState state = at_height(GENERATE(0.0, 7.5));
    state.derivatives = true;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.derivatives);
    state.derivatives = false;
    const auto differences = [&](const std::function<void(WheelRailState&, double)>& move, double step,
                                 const Wrench& known) {
        WheelRailState more = state, less = state;
        move(more, step);
        move(less, -step);
        const Wrench a = solve(setup, more).forces.track, b = solve(setup, less).forces.track;
        const double largest = std::max({std::abs(known.Fx), std::abs(known.Fy), std::abs(known.Fz)});
        for (double Wrench::* of : {&Wrench::Fx, &Wrench::Fy, &Wrench::Fz})
            CHECK_THAT((a.*of - b.*of) / (2 * step), WithinAbs(known.*of, 0.05 * largest));
        CHECK_THAT((a.Mx - b.Mx) / (2 * step), WithinAbs(known.Mx, 0.05 * 760 * largest));
    };
    const auto& [position, velocity] = *solution.derivatives;
    differences([](WheelRailState& at, double by) { *at.position.z += by; }, 5e-3, position.z);
    differences([](WheelRailState& at, double by) { at.position.y += by; }, 1e-2, position.y);
    differences([](WheelRailState& at, double by) { at.velocity.y += by; }, 4, velocity.y);
}

TEST_CASE("A soft rail that a flange pushes far aside is in balance") {
    const WheelRailSetup setup = on_flexible_rail(1000, {});
    for (const double y : {28.0, 32.0}) {
        const WheelRailState state = under_force(y);
        const WheelRailSolution solution = solve(setup, state);
        check_balance(setup, state, solution);
        // The flange has a clearance of about 6 mm, beyond which the rail follows.
        CHECK(solution.rail_deflection->y > y - 7);
        CHECK(solution.rail_deflection->y < y - 4);
    }
}

TEST_CASE("Without a wheel on it a rail lies where the other forces have it") {
    const WheelRailSetup setup = on_flexible_rail(1e4, 2e4);
    WheelRailState state;
    state.position.z = -3;
    state.rail.Fy = 500;
    state.rail.Fz = -1000;
    const WheelRailSolution solution = solve(setup, state);
    CHECK_FALSE(solution.in_contact());
    CHECK(solution.converged());
    CHECK_THAT(solution.rail_deflection.value().y, WithinAbs(0.05, 1e-9));
    CHECK_THAT(solution.rail_deflection->z, WithinAbs(-0.05, 1e-9));
    state.position = {};
    state.position.y = 200;
    state.Fz = 1e4;
    CHECK_FALSE(solve(setup, state).in_contact());
}

TEST_CASE("A left rail deflects as a right one in a mirror") {
    WheelRailSetup setup = on_flexible_rail(2e4, 1e5);
    WheelRailState state = under_force(7.4);
    state.rail.Fy = 800;
    const WheelRailSolution right = solve(setup, state);
    setup.side = Side::left;
    const WheelRailSolution left = mirrored(solve(setup, mirrored(state)));
    CHECK(left.rail_deflection.value() == right.rail_deflection.value());
    CHECK(left.forces.track == right.forces.track);
}

TEST_CASE("A step of a wheel starts where its rail was, and ends where it is without one") {
    const WheelRailSetup setup = on_flexible_rail(2e4, 1e5);
    const WheelRailContact contact(setup);
    WheelRailEstimates estimates;
    Observer observer;
    const WheelRailSolution first = contact.solve(under_force(7.0), estimates, observer);
    CHECK(first.forces.track == contact.solve(under_force(7.0), observer).forces.track);
    const WheelRailSolution again = contact.solve(under_force(7.01), estimates, observer);
    const WheelRailSolution alone = contact.solve(under_force(7.01), observer);
    CHECK(again.rail_search.value().iterations < alone.rail_search.value().iterations);
    check_same_forces(again.forces.track, alone.forces.track, 1e-5);
}

TEST_CASE("A step of a conformal contact on a flexible rail, under Fz and Fx, takes at most fifteen solves") {
    WheelRailSetup setup = on_flexible_rail(2e4, 5e4);
    setup.dx = setup.dy = 1;
    setup.conformal = Conformal::rotated;
    const WheelRailContact contact(setup);
    WheelRailEstimates estimates;
    Observer observer;
    WheelRailState state = under_force(4);
    state.Fx = 3000;
    for (int k = 0; k < 4; ++k) {
        state.position.y += 0.02;
        const WheelRailSolution solution = contact.solve(state, estimates, observer);
        check_balance(setup, state, solution);
        CHECK_THAT(solution.forces.wheelset.Fx, WithinAbs(3000, 1e-6 * 80000));
        if (k > 0) CHECK(solution.rail_search.value().iterations <= 15);
    }
}

TEST_CASE("A wheelset rolls where the rails below it deflect unlike") {
    WheelRailSetup right = on_flexible_rail({}, 2e4), left = right;
    left.side = Side::left;
    WheelsetState state;
    state.Fz_left = 40000;
    state.Fz_right = 80000;
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    Observer observer;
    const WheelsetSolution solution = solve_wheelset(WheelRailContact(left), WheelRailContact(right), state, observer);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.right.rail_deflection.value().z, WithinRel(4, 1e-5));
    CHECK_THAT(solution.left.rail_deflection.value().z, WithinRel(2, 1e-5));
    state.left_rail.z = solution.left.rail_deflection->z;
    state.right_rail.z = solution.right.rail_deflection->z;
    left.track.springs.reset();
    right.track.springs.reset();
    const WheelsetSolution fixed = solve_wheelset(WheelRailContact(left), WheelRailContact(right), state, observer);
    CHECK_THAT(solution.roll, WithinAbs(fixed.roll, 1e-6));
    CHECK_THAT(solution.z, WithinAbs(fixed.z, 1e-5));
}

TEST_CASE("A warning tells of a rail that deflects by more than rails do") {
    const auto reported = [](double z) {
        const WheelRailSolution solution = solve(on_flexible_rail({}, z), under_force(0));
        REQUIRE(solution.converged());
        for (const std::string& warning : solution.warnings)
            if (warning.starts_with("The rail deflects by 800 mm") && warning.ends_with("in N/mm.")) return true;
        return false;
    };
    CHECK(reported(100));  // meant as kN/mm
    CHECK_FALSE(reported(1e5));
}

TEST_CASE("Mistakes in springs and loads are refused by name") {
    const auto refused = [](const WheelRailSetup& setup, const WheelRailState& state, const std::string& sentence) {
        Observer observer;
        CHECK_THROWS_AS(solve_wheel_rail(setup, state, observer), InvalidArgument);
        CHECK_THROWS_WITH(solve_wheel_rail(setup, state, observer), ContainsSubstring(sentence));
    };
    refused(on_flexible_rail({}, {}), {}, "track.springs has neither y nor z");
    refused(on_flexible_rail(-1, {}), {}, "track.springs.y is -1");
    refused(on_flexible_rail({}, NAN), {}, "track.springs.z is nan");
    refused(on_flexible_rail({}, INFINITY), {}, "track.springs.z is inf; it must be positive and at most");
    WheelRailState state;
    state.rail.Fy = 100;
    refused(on_flexible_rail({}, 1e5), state, "state.rail.Fy is 100, but the rail is rigid in that direction");
    refused({}, state, "state.rail.Fy is 100");
    WheelsetState both;
    both.Fz_left = both.Fz_right = 1e4;
    both.left_rail.Fz = 5;
    WheelRailSetup left;
    left.side = Side::left;
    Observer observer;
    CHECK_THROWS_WITH(solve_wheelset(WheelRailContact(left), WheelRailContact(WheelRailSetup{}), both, observer),
                      ContainsSubstring("left_rail.Fz is 5, but the rail is rigid in that direction"));
    state.rail.Fy = NAN;
    refused(on_flexible_rail(1e5, 1e5), state, "state.rail.Fy is nan");
}

// Tests steps of a wheel on a rail in which the force decreases as patches merge, so that several heights have the same
// force.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <string>
#include <vector>

#include "wheel_rail/position/branch.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Uses a head inclined by 1/20, near the flange's throat, where three regions merge to two as the load grows.
WheelRailSetup merging() {
    WheelRailSetup setup;
    setup.rail.shape = Rail60E1{1.0 / 20};
    setup.dx = setup.dy = 0.5;
    setup.friction.reset();
    return setup;
}

WheelRailState under(double Fz) {
    WheelRailState state;
    state.position.y = 5.598;
    state.position.roll = -0.0011423;
    state.position.yaw = -0.00061207;
    state.Fz = Fz;
    return state;
}

/// Returns the last step of some successive loads.
WheelRailSolution last_of(const WheelRailContact& contact, const std::vector<double>& loads) {
    WheelRailEstimates estimates;
    Observer observer;
    WheelRailSolution solution;
    for (const double Fz : loads) solution = contact.solve(under(Fz), estimates, observer);
    return solution;
}

}  // namespace

TEST_CASE("A step stays on the branch of the step before where two heights bring its force") {
    const WheelRailContact contact(merging());
    const WheelRailSolution apart = last_of(contact, {90000, 91000, 92000, 92500}),
                            merged = last_of(contact, {95000, 93000, 92500});
    REQUIRE(regions_in(apart) == 3);
    REQUIRE(regions_in(merged) == 2);
    for (const WheelRailSolution& solution : {apart, merged}) {
        CHECK(solution.converged());
        CHECK_THAT(solution.forces.track.Fz, WithinRel(92500, 1e-6));
        // The force at the computed height is the prescribed one.
        WheelRailState state = under(1);
        state.Fz.reset();
        state.position.z = solution.z;
        CHECK_THAT(solve(merging(), state).forces.track.Fz, WithinRel(92500, 1e-4));
    }
    CHECK(merged.z > apart.z + 1e-3);
}

TEST_CASE("A given height at which the force falls is warned of") {
    const WheelRailContact contact(merging());
    Observer observer;
    const double apart = last_of(contact, {90000, 91000, 92000, 92500}).z, merged = last_of(contact, {95000, 92500}).z;
    const auto at = [&](double z) {
        WheelRailState state = under(1);
        state.Fz.reset();
        state.position.z = z;
        return contact.solve(state, observer);
    };
    const auto warned = [](const WheelRailSolution& solution) {
        return std::ranges::any_of(solution.warnings, [](const std::string& warning) {
            return warning.starts_with("The vertical force decreases while the wheel is lowered near z = ");
        });
    };
    const auto border = nearest_height([&](double z) { return regions_in(at(z)) < 3; }, apart, merged);
    REQUIRE(border);
    REQUIRE(at(*border + 1e-5).forces.track.Fz < at(*border - 1e-5).forces.track.Fz - 1000);
    CHECK(warned(at(*border - 1e-4)));
    CHECK(warned(at(*border + 1e-4)));
    CHECK_FALSE(warned(at(apart - 0.02)));
    CHECK_FALSE(warned(at(merged + 0.02)));
}

TEST_CASE("The height where a branch begins is found between those that are not on it") {
    const auto beyond = nearest_height([](double z) { return z > 0.25; }, 0.1, 0.5);
    REQUIRE(beyond);
    CHECK_THAT(*beyond, WithinAbs(0.25, 2e-7));
    CHECK_FALSE(nearest_height([](double z) { return z > 0.6; }, 0.1, 0.5));
    const auto above = nearest_height([](double z) { return z < 0.2; }, 0.3, 0.1);
    REQUIRE(above);
    CHECK_THAT(*above, WithinAbs(0.2, 2e-7));
}

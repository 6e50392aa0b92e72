// Tests a requested accuracy, and the estimate of an answer's own accuracy.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double largest_traction(const ContactSolution& solution) {
    double found = 0;
    for (std::size_t i = 0; i < solution.traction_x.size(); ++i)
        found = std::max(found, std::hypot(solution.traction_x[i], solution.traction_y[i]));
    return found;
}

/// Returns forces over the normal force, and largest values over these.
double difference(const WheelRailSolution& one, const WheelRailSolution& other) {
    double found = 0;
    REQUIRE(one.patches.size() == other.patches.size());
    for (std::size_t i = 0; i < one.patches.size(); ++i) {
        const WheelRailPatch &a = one.patches[i], &b = other.patches[i];
        const double Fn = b.solution.forces.Fn;
        for (const auto force : {&Wrench::Fx, &Wrench::Fy, &Wrench::Fz})
            found = std::max(found, std::abs(a.forces.track.*force - b.forces.track.*force) / Fn);
        const double pmax = largest(b.solution.pressure), gmax = largest_traction(b.solution);
        found = std::max(found, std::abs(largest(a.solution.pressure) - pmax) / pmax);
        found = std::max(found, std::abs(largest_traction(a.solution) - gmax) / gmax);
    }
    return found;
}

/// Creates a hunting wheelset, at one of its steps.
WheelRailState step(int number) {
    const double way = 0.05 * number;
    WheelRailState state;
    state.position = {3 * std::sin(way), 0, -1.5e-4 * std::sin(way), 2e-3 * std::cos(way)};
    state.velocity = {20000, 63 * std::cos(way), 0, 0, 0, -20000 / 460.0};
    state.Fz = 80000 * (1 + 0.05 * std::sin(7 * way));
    return state;
}

WheelRailSetup coarse() {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    return setup;
}

}  // namespace

TEST_CASE("Forces and largest values are as near to those of tight tolerances as was asked for, step for step") {
    const double accuracy = GENERATE(1e-3, 1e-4, 1e-5, 1e-6);
    WheelRailSetup setup = coarse(), tight = coarse();
    setup.accuracy = accuracy;
    tight.settings = {{1e-11, 1000}, {1e-10, 1000}, {1e-10, 100}};
    const WheelRailContact contact(setup), reference(tight);
    WheelRailEstimates estimates;
    Observer observer;
    double off = 0, estimated = 0;
    for (int number = 0; number < 60; ++number) {
        const WheelRailState state = step(number);
        const WheelRailSolution solution = contact.solve(state, estimates, observer);
        REQUIRE(solution.converged());
        REQUIRE(solution.accuracy);
        CHECK(std::abs(solution.forces.track.Fz - *state.Fz) <= accuracy * *state.Fz);
        WheelRailState there = state;
        there.Fz.reset();
        there.position.z = solution.z;
        off = std::max(off, difference(solution, reference.solve(there, observer)));
        estimated = std::max(estimated, *solution.accuracy);
    }
    CHECK(off <= accuracy);
    CHECK(estimated <= accuracy);
    CHECK(off <= estimated);
}

TEST_CASE("A coarser accuracy takes fewer solves") {
    const auto solves = [](double accuracy) {
        WheelRailSetup setup = coarse();
        setup.accuracy = accuracy;
        const WheelRailContact contact(setup);
        WheelRailEstimates estimates;
        Observer observer;
        int all = 0;
        for (int number = 0; number < 20; ++number)
            all += contact.solve(step(number), estimates, observer).force->iterations;
        return all;
    };
    CHECK(solves(1e-4) < solves(1e-7));
}

TEST_CASE("Without an accuracy tolerances are those of the settings, and the answer tells what they bring") {
    WheelRailSetup setup = coarse();
    setup.settings = {{1e-7, 1000}, {1e-5, 1000}, {1e-5, 100}};
    CHECK(with_tolerances(setup) == setup);
    const WheelRailSolution solution = solve(setup, step(3));
    REQUIRE(solution.accuracy);
    CHECK(*solution.accuracy > 0);
    CHECK(*solution.accuracy <= 1e-5);
    setup.model = Model::fastsim;
    CHECK_FALSE(solve(setup, step(3)).accuracy);
}

TEST_CASE("An accuracy that no solver brings is refused") {
    WheelRailSetup setup = coarse();
    setup.accuracy = GENERATE(0.0, -1e-4, 0.1, std::nan(""));
    CHECK_THROWS_AS(solve(setup, step(0)), InvalidArgument);
}

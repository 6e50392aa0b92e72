// Tests the derivatives of the pressures of a wheel's patches by their approaches.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numeric>

#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// S1002 on 60E1 on elements of 0.5 mm, without friction.
WheelRailSetup frictionless() {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.friction.reset();
    return setup;
}

/// A cylinder on two arcs of a rail, 40 mm apart, one of which is lower.
WheelRailSetup on_two_arcs() {
    WheelRailSetup setup = cylinder_on_arc(300);
    ProfilePoints rail;
    for (double y = -38; y <= 32; y += 0.25)
        rail.points.push_back(
            {y, std::min(200 - std::sqrt(4e4 - std::pow(y + 22, 2)), 80.01 - std::sqrt(6400 - std::pow(y - 18, 2)))});
    setup.rail.shape = rail;
    setup.wheel.shape = ConeProfile{0.001, -40, 40};
    setup.dx = setup.dy = 0.2;
    return setup;
}

WheelRailState at_y(double y) {
    WheelRailState state;
    state.position.y = y;
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 80e3;
    state.derivatives = true;
    return state;
}

double stiffness_of(const WheelRailPatch& patch) {
    const auto& values = patch.solution.pressure_by_approach;
    REQUIRE(values.size() == patch.place.grid.size());
    return std::accumulate(values.begin(), values.end(), 0.0) * patch.place.grid.element_area();
}

/// Returns dFz/dz from normal approaches, which change by cos(angle) dz.
double vertical_stiffness(const WheelRailSolution& solution) {
    double sum = 0;
    for (const WheelRailPatch& patch : solution.patches)
        sum += std::pow(std::cos(patch.place.reference.angle), 2) * stiffness_of(patch);
    return sum;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double most = 0, difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::abs(b[i]));
        difference = std::max(difference, std::abs(a[i] - b[i]));
    }
    return difference / most;
}

const std::vector<double>& first_array(const WheelRailSolution& solution) {
    REQUIRE(solution.derivatives);
    REQUIRE(!solution.patches.empty());
    return solution.patches[0].solution.pressure_by_approach;
}

}  // namespace

TEST_CASE("The patches together are as stiff as the wheel that goes down") {
    const bool two = GENERATE(false, true);
    const double y = two ? 0 : GENERATE(0.0, 3.0, 5.5);
    const WheelRailSolution solution = solve(two ? on_two_arcs() : frictionless(), at_y(y));
    CAPTURE(y);
    REQUIRE(solution.patches.size() == (two ? 2 : 1));
    REQUIRE(solution.derivatives);
    // Elements come into contact and leave it between the heights of the difference.
    CHECK_THAT(vertical_stiffness(solution), WithinRel(solution.derivatives->position.z.Fz, 0.03));
}

TEST_CASE("Pressures follow the height of a wheel whose contact stays in place") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 0.5;
    setup.settings.normal.tolerance = 1e-12;
    const WheelRailSolution solution = solve(setup, at_y(0));
    const WheelRailPatch& patch = solution.patches.at(0);
    WheelRailState state = at_y(0);
    state.derivatives = false;
    state.Fz.reset();
    const double step = 1e-6 * patch.solution.approach;  // No element comes into contact or leaves it.
    const auto pressures_at = [&](double z) {
        state.position.z = z;
        return solve(setup, state).patches.at(0).solution.pressure;
    };
    std::vector<double> quotients = pressures_at(solution.z + step);
    const std::vector<double> less = pressures_at(solution.z - step);
    REQUIRE(less.size() == quotients.size());
    for (std::size_t i = 0; i < less.size(); ++i) quotients[i] = (quotients[i] - less[i]) / (2 * step);
    CHECK(largest_difference(patch.solution.pressure_by_approach, quotients) < 1e-4);
}

TEST_CASE("Friction does not affect how pressures of similar bodies change") {
    WheelRailSetup setup = frictionless();
    const WheelRailSolution plain = solve(setup, at_y(2));
    WheelRailState state = at_y(2);
    state.Fz.reset();
    state.position.z = plain.z;
    const std::vector<double> expected = first_array(solve(setup, state));
    setup.friction = WheelRailFriction{};
    SECTION("in steady rolling") {}
    SECTION("with a slip law") {
        setup.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.2, 1000};
    }
    SECTION("in transient rolling") {
        state.motion = WheelRailMotion::transient_rolling;
    }
    CHECK(largest_difference(first_array(solve(setup, state)), expected) < 1e-5);
}

TEST_CASE("Friction affects how pressures of dissimilar bodies change") {
    WheelRailSetup setup = frictionless();
    setup.bodies.upper.material = {20000, 0.1};
    WheelRailState state = at_y(2);
    state.Fz.reset();
    state.position.z = solve(setup, at_y(2)).z;
    const std::vector<double> plain = first_array(solve(setup, state));
    setup.friction = WheelRailFriction{};
    CHECK(largest_difference(first_array(solve(setup, state)), plain) > 1e-3);
    setup.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.2, 1000};
    CHECK(first_array(solve(setup, state)).empty());
}

TEST_CASE("A flexible rail carries the patches in series with its spring") {
    WheelRailSetup setup = frictionless();
    constexpr double spring = 1e6;
    setup.track.springs = {std::nullopt, spring};
    const WheelRailSolution solution = solve(setup, at_y(1));
    REQUIRE(solution.derivatives);
    const double contact = vertical_stiffness(solution);
    CHECK_THAT(solution.derivatives->position.z.Fz, WithinRel(contact * spring / (contact + spring), 0.03));
}

TEST_CASE("Patches of a left wheel have their arrays mirrored") {
    WheelRailSetup setup = frictionless();
    const WheelRailSolution right = solve(setup, at_y(2));
    setup.side = Side::left;
    const WheelRailSolution left = solve(setup, at_y(-2));
    const Grid& grid = right.patches.at(0).place.grid;
    std::vector<double> mirrored;
    for (int iy = grid.ny - 1; iy >= 0; --iy) {
        const auto row = first_array(left).begin() + static_cast<std::ptrdiff_t>(iy) * grid.nx;
        mirrored.insert(mirrored.end(), row, row + grid.nx);
    }
    CHECK(largest_difference(mirrored, first_array(right)) < 1e-9);
}

TEST_CASE("Patches without derivatives of their pressures have no array") {
    WheelRailSetup setup = frictionless();
    WheelRailState state = at_y(0);
    SECTION("a simplified model") {
        setup.model = Model::fastsim;
        CHECK(first_array(solve(setup, state)).empty());
    }
    SECTION("virtual penetration") {
        setup.model = Model::fastsim;
        setup.normal_model = NormalModel::kp;
        CHECK(first_array(solve(setup, state)).empty());
    }
    SECTION("not requested") {
        state.derivatives = false;
        CHECK(solve(setup, state).patches.at(0).solution.pressure_by_approach.empty());
    }
}

// Tests contacts that are curved across the track.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "geometry/placement/vector3.hpp"
#include "wheel_rail/manchester.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double of_rail = 13, of_wheel = 13.3;

/// Creates a wheel with a throat on a rail that nearly fills it.
WheelRailSetup throat_on_rail(Conformal conformal) {
    WheelRailSetup setup = cylinder_on_arc(of_rail);
    setup.rail.shape = ArcProfile{of_rail, 0, -10, 10};
    setup.wheel.shape = ArcProfile{of_wheel, 0, -10, 10};
    setup.dx = setup.dy = 0.25;
    setup.conformal = conformal;
    return setup;
}

WheelRailState loaded(double Fz) {
    WheelRailState state;
    state.Fz = Fz;
    return state;
}

bool warns(const WheelRailSolution& solution, const std::string& part) {
    return std::any_of(solution.warnings.begin(), solution.warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("Rows of a curved contact lie half-way between rail and wheel, along both") {
    const WheelRailSolution solution = solve(throat_on_rail(Conformal::half_space), loaded(60000));
    REQUIRE(solution.converged());
    REQUIRE(solution.patches.size() == 1);
    const ContactPlace& place = solution.patches[0].place;
    REQUIRE(static_cast<int>(place.rows.size()) == place.grid.ny);
    CHECK(!warns(solution, "too strongly curved"));
    for (int iy = 0; iy < place.grid.ny; ++iy) {
        const ContactRow& row = place.rows[static_cast<std::size_t>(iy)];
        const double s = place.grid.y(iy), mean = 0.5 * (1 / of_rail + 1 / of_wheel) * s;
        INFO("row at " << s << " mm");
        CHECK_THAT(row.angle, WithinAbs(mean, 1e-6));
        const double y = 0.5 * (of_rail * std::sin(s / of_rail) + of_wheel * std::sin(s / of_wheel));
        CHECK_THAT(row.y - place.reference.y, WithinAbs(y, 1e-6));
    }
}

// Uses nearly equal radii, so that the contact extends to nearly upright rows.
TEST_CASE("A wheel between the nodes of a mesh reaches as far as the rows of a wide curved contact") {
    WheelRailSetup setup = throat_on_rail(Conformal::half_space);
    setup.dx = 0.5;
    setup.dy = 0.1;
    setup.rail.shape = ArcProfile{of_rail, 0, -12.8, 12.8};
    setup.wheel.shape = ArcProfile{of_rail + 0.02, 0, -12.8, 12.8};
    WheelRailState state;
    state.position.z = 0.05;
    const WheelRailSolution exact = solve(setup, state);
    setup.wheel_surface = WheelSurfaceKind::bilinear;
    const WheelRailSolution meshed = solve(setup, state);
    REQUIRE(exact.patches.size() == 1);
    REQUIRE(meshed.patches.size() == 1);
    const std::vector<ContactRow>& rows = exact.patches[0].place.rows;
    REQUIRE(rows.front().angle < -1.2);
    REQUIRE(rows.back().angle > 1.2);
    const std::vector<double>&of_exact = exact.patches[0].gap, &of_meshed = meshed.patches[0].gap;
    REQUIRE(of_meshed.size() == of_exact.size());
    for (std::size_t i = 0; i < of_exact.size(); ++i) REQUIRE_THAT(of_meshed[i], WithinAbs(of_exact[i], 0.01));
}

// The distance along the normal between two circles that touch at their lowest points grows by the difference of the
// radii.
TEST_CASE("Gaps of a curved contact are those along each row's normal") {
    const WheelRailSolution solution = solve(throat_on_rail(Conformal::half_space), loaded(60000));
    const WheelRailPatch& patch = solution.patches.at(0);
    const Grid& grid = patch.place.grid;
    const auto middle = static_cast<int>(std::lround(-grid.x(0) / grid.dx));
    REQUIRE_THAT(grid.x(middle), WithinAbs(0, 1e-9));
    double largest = 0;
    for (int iy = 0; iy < grid.ny; ++iy) {
        const double angle = patch.place.rows[static_cast<std::size_t>(iy)].angle;
        const double h = patch.gap[static_cast<std::size_t>(iy * grid.nx + middle)] - patch.solution.approach;
        const double expected =
            (of_wheel - of_rail) * (1 - std::cos(angle)) - patch.solution.approach * std::cos(angle);
        CHECK_THAT(h, WithinAbs(expected, 1e-3));
        largest = std::max(largest, angle);
    }
    CHECK(largest > 0.4);
}

TEST_CASE("The sum of the rotated tractions is the force that was asked for") {
    WheelRailSetup setup = throat_on_rail(Conformal::half_space);
    const WheelRailSolution solution = solve(setup, loaded(60000));
    const WheelRailPatch& patch = solution.patches.at(0);
    const Grid& grid = patch.place.grid;
    double Fz = 0, plain = 0;
    std::size_t i = 0;
    for (const ContactRow& row : patch.place.rows)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            Fz += grid.element_area() * patch.solution.pressure[i] * std::cos(row.angle);
            plain += grid.element_area() * patch.solution.pressure[i];
        }
    CHECK_THAT(solution.forces.track.Fz, WithinRel(60000, 1e-6));
    CHECK_THAT(Fz, WithinRel(60000, 1e-6));
    CHECK_THAT(patch.solution.forces.Fn, WithinRel(plain, 1e-9));
    CHECK(plain > 1.01 * Fz);
    CHECK_THAT(solution.forces.track.Fy, WithinAbs(0, 1e-3));
    // With flat rows the same contact warns, and its pressure differs.
    setup.conformal = Conformal::off;
    const WheelRailSolution plane = solve(setup, loaded(60000));
    CHECK(warns(plane, "too strongly curved"));
    CHECK(plane.patches.at(0).solution.pmax < 0.99 * patch.solution.pmax);
}

TEST_CASE("Where the surfaces are nearly flat a curved contact is that of the plane with the slip of the surfaces") {
    const ManchesterCase known = manchester_cases[GENERATE(0, 3, 6)];
    WheelRailSetup setup = manchester_setup(known.side);
    setup.rigid_slip = RigidSlipKind::surfaces;
    const WheelRailSolution plane = solve(setup, manchester_state(known));
    setup.conformal = Conformal::half_space;
    const WheelRailSolution curved = solve(setup, manchester_state(known));
    REQUIRE(curved.converged());
    REQUIRE(curved.patches.size() == plane.patches.size());
    CHECK_THAT(curved.patches[0].solution.pmax, WithinRel(plane.patches[0].solution.pmax, 5e-3));
    CHECK_THAT(curved.forces.track.Fx, WithinAbs(plane.forces.track.Fx, 0.01 * 3000));
    CHECK_THAT(curved.forces.track.Fy, WithinAbs(plane.forces.track.Fy, 0.01 * 3000));
    CHECK_THAT(curved.patches[0].place.creepages.eta, WithinAbs(plane.patches[0].place.creepages.eta, 1e-4));
}

TEST_CASE("Friction of a curved contact takes the power that the motion gives") {
    WheelRailSetup setup = throat_on_rail(Conformal::half_space);
    setup.friction = WheelRailFriction{};
    WheelRailState state = loaded(60000);
    state.position.yaw = 0.002;
    state.velocity = {20000, 0, 0, 0, 0, -20000 / 450.0};
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE(solution.converged());
    using geometry::Vector3;
    const Wrench& on_rail = solution.forces.track;
    const auto axes = geometry::Rotation::yaw_then_roll(0.002, 0);
    const Vector3 angular_velocity = axes * Vector3{0, state.velocity.pitch, 0};
    const Vector3 centre{0, 0, solution.z - setup.wheelset.nominal_radius};
    const Vector3 at_origin = Vector3{20000, 0, 0} + cross(angular_velocity, Vector3{} - centre);
    const double given = dot(Vector3{on_rail.Fx, on_rail.Fy, on_rail.Fz}, at_origin) +
                         dot(Vector3{on_rail.Mx, on_rail.My, on_rail.Mz}, angular_velocity);
    const double taken = solution.patches.at(0).solution.frictional_power.value();
    CHECK(taken > 0);
    CHECK_THAT(given, WithinRel(taken, 0.05));
}

TEST_CASE("A left wheel in a curved contact is a right one in a mirror") {
    WheelRailSetup setup;
    setup.conformal = Conformal::half_space;
    setup.dx = setup.dy = 0.4;
    WheelRailState state;
    state.position = {5.5, 0, 0.001, 0.01};
    state.velocity = {20000, 0, 0, 0, 0, -20000 / 460.0};
    state.Fz = 60000;
    const WheelRailSolution right = solve(setup, state);
    setup.side = Side::left;
    state.position = {-5.5, 0, -0.001, -0.01};
    const WheelRailSolution left = solve(setup, state);
    CHECK(left.forces.track.Fx == right.forces.track.Fx);
    CHECK(left.forces.track.Fy == -right.forces.track.Fy);
    REQUIRE(left.patches.size() == right.patches.size());
    const auto &a = left.patches.front().place.rows, &b = right.patches.back().place.rows;
    REQUIRE(a.size() == b.size());
    CHECK(a.front().angle == -b.back().angle);
    CHECK(a.front().y == -b.back().y);
}

TEST_CASE("Simplified models know no curved contacts") {
    WheelRailSetup setup = throat_on_rail(Conformal::half_space);
    setup.model = Model::hertz;
    CHECK_THROWS_WITH(validate(setup), ContainsSubstring("conformal is not off"));
}

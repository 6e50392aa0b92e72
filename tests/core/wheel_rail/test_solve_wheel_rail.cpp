#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <optional>

#include "closed_forms/hertz.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/random_wheel_rail.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

void same(const Wrench& a, const Wrench& b) {
    CHECK(a == b);
}

}  // namespace

TEST_CASE("A left wheel is a right one in a mirror, to the last bit") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.friction = WheelRailFriction{{{-0.5, 0.2}, {0.1, 0.4}}, true, {}};
    WheelRailState state;
    state.position = {6, 0, 0.002, 0.012};
    state.rail = {0.3, 0.1, 0.004};
    state.velocity = {20000, 15, 3, 0.01, 0.02, -43};
    state.Fz = 60000;
    const WheelRailSolution right = solve(setup, state);
    setup.side = Side::left;
    const WheelRailSolution left = mirrored(solve(setup, mirrored(state)));
    CHECK(left.z == right.z);
    same(left.forces.track, right.forces.track);
    same(left.forces.rail, right.forces.rail);
    same(left.forces.wheelset, right.forces.wheelset);
    REQUIRE(left.patches.size() == right.patches.size());
    REQUIRE_FALSE(right.patches.empty());
    for (std::size_t i = 0; i < left.patches.size(); ++i) {
        CHECK(left.patches[i].place.reference == right.patches[i].place.reference);
        CHECK(left.patches[i].solution.pressure == right.patches[i].solution.pressure);
        CHECK(left.patches[i].solution.traction_y == right.patches[i].solution.traction_y);
        CHECK(left.patches[i].gap == right.patches[i].gap);
    }
}

TEST_CASE("The height that a force brings brings that force") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.model = GENERATE(Model::full, Model::fastsim, Model::fastrip, Model::polach);
    WheelRailState state;
    state.position.y = GENERATE(0.0, 5.3, 7.5);
    state.position.yaw = 0.01;
    state.velocity = {20000, 0, 0, 0, 0, -43.5};
    state.Fz = 80000;
    const WheelRailSolution by_force = solve(setup, state);
    REQUIRE(by_force.converged());
    CHECK_THAT(by_force.forces.track.Fz, WithinRel(80000, 1e-6));
    state.Fz.reset();
    state.position.z = by_force.z;
    const WheelRailSolution by_height = solve(setup, state);
    const Wrench &one = by_height.forces.track, &other = by_force.forces.track;
    CHECK_THAT(one.Fz, WithinRel(other.Fz, 2e-6));
    for (double Wrench::* force : {&Wrench::Fx, &Wrench::Fy})
        CHECK_THAT(one.*force, WithinAbs(other.*force, 1e-5 * other.Fz));
    REQUIRE(by_height.patches.size() == by_force.patches.size());
    for (std::size_t i = 0; i < by_height.patches.size(); ++i)
        CHECK_THAT(by_height.patches[i].solution.pmax, WithinRel(by_force.patches[i].solution.pmax, 1e-5));
    CHECK(by_height.z == by_force.z);
}

TEST_CASE("Pressures of virtual penetration carry a force on a rail, and stand near those of boundary elements") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.25;
    WheelRailState state;
    state.position.y = 3;
    state.velocity = {20000, 0, 0, 0, 0, -43.5};
    state.Fz = 80000;
    const WheelRailSolution elastic = solve(setup, state);
    setup.normal_model = GENERATE(NormalModel::kp, NormalModel::kpec, NormalModel::analyn);
    setup.model = GENERATE(Model::full, Model::fastsim, Model::fastrip, Model::polach);
    const WheelRailSolution found = solve(setup, state);
    // Forces of kpec jump by a few millionths where rows of elements enter its region, and no height has the forces in
    // between.
    CHECK_THAT(found.forces.track.Fz, WithinRel(80000, 1e-5));
    REQUIRE(found.patches.size() == elastic.patches.size());
    CHECK_THAT(found.z, WithinAbs(elastic.z, 0.03));
    CHECK_THAT(found.patches[0].solution.pmax, WithinRel(elastic.patches[0].solution.pmax, 0.25));

    WheelRailSetup left = setup;
    left.side = Side::left;
    WheelRailState mirrored = state;
    mirrored.position.y = -3;
    const WheelRailSolution other = solve(left, mirrored);
    CHECK_THAT(other.forces.track.Fx, WithinRel(found.forces.track.Fx, 1e-6));
    CHECK_THAT(other.forces.track.Fy, WithinRel(-found.forces.track.Fy, 1e-6));
}

TEST_CASE("A wheel that is lifted has no contact, and says how far it is away") {
    WheelRailState state;
    const WheelRailContact contact(WheelRailSetup{});
    const std::optional<double> height = contact.first_contact_height(state);
    REQUIRE(height);
    state.position.z = *height - 0.5;
    Observer observer;
    const WheelRailSolution solution = contact.solve(state, observer);
    CHECK_FALSE(solution.in_contact());
    CHECK(solution.forces.track == Wrench{});
    CHECK_THAT(solution.clearance.value(), WithinAbs(0.5, 1e-12));
}

TEST_CASE("A wheel beside its rail has no contact at any height") {
    WheelRailState state;
    state.position.y = 200;
    state.Fz = GENERATE(std::optional<double>{}, std::optional(1e4));
    const WheelRailSolution solution = solve({}, state);
    CHECK_FALSE(solution.in_contact());
    CHECK_FALSE(solution.clearance);
    REQUIRE(solution.warnings.size() == 1);
    CHECK_THAT(solution.warnings[0], ContainsSubstring("above the rail"));
}

TEST_CASE("A cylinder on an arc is Hertz's contact") {
    const double radius = GENERATE(100.0, 300.0), Fn = 60000;
    WheelRailSetup setup = cylinder_on_arc(radius);
    setup.model = GENERATE(Model::full, Model::hertz);
    setup.dx = setup.dy = 0.25;
    WheelRailState state;
    state.Fz = Fn;
    double along = 450;
    SECTION("on a rail") {}
    SECTION("on a roller") {
        setup.track.roller_radius = 600;
        along = 1 / (1 / 450.0 + 1 / 600.0);
    }
    const WheelRailSolution solution = solve(setup, state);
    const HertzContact known = hertz_of_force({along, radius}, setup.bodies.materials().normal_compliance(), Fn);
    REQUIRE(solution.converged());
    REQUIRE(solution.patches.size() == 1);
    const WheelRailPatch& patch = solution.patches[0];
    CHECK_THAT(patch.place.reference.y, WithinAbs(750, 1e-6));
    CHECK_THAT(patch.place.reference.angle, WithinAbs(0, 1e-8));
    CHECK_THAT(patch.solution.pmax, WithinRel(known.pmax, 5e-3));
    CHECK_THAT(patch.solution.approach, WithinRel(known.approach, 5e-3));
    CHECK_THAT(patch.place.radii.wheel_along, WithinRel(450, 1e-6));
    CHECK_THAT(patch.place.radii.rail_across, WithinRel(radius, 1e-4));
    CHECK_THAT(solution.z, WithinRel(known.approach, 5e-3));
}

TEST_CASE("Forces have the same moment in all coordinates") {
    WheelRailState state;
    state.position = {7.2, 0, 0.001, 0.015};
    state.velocity = {20000, 0, 0, 0, 0, -43};
    state.Fz = 50000;
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    const WheelRailSolution solution = solve(setup, state);
    const Wrench &track = solution.forces.track, &wheelset = solution.forces.wheelset;
    // Computes the moment about the axle's centre (0, y, z - r) by hand; the axes roll and yaw, which preserves the
    // length.
    const double y = state.position.y, z = solution.z - 460;
    const double Mx = track.Mx - (y * track.Fz - z * track.Fy), My = track.My - z * track.Fx,
                 Mz = track.Mz + y * track.Fx;
    CHECK_THAT(std::hypot(wheelset.Mx, wheelset.My, wheelset.Mz), WithinRel(std::hypot(Mx, My, Mz), 1e-10));
    CHECK_THAT(wheelset.Fx * wheelset.Mx + wheelset.Fy * wheelset.My + wheelset.Fz * wheelset.Mz,
               WithinRel(track.Fx * Mx + track.Fy * My + track.Fz * Mz, 1e-9));
}

TEST_CASE("Random positions have an answer, and their forces balance") {
    Observer observer;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Dice dice(seed);
        RandomWheelRail problem{random_setup(dice, 1), {}};
        const WheelRailContact contact(problem.setup);
        for (int i = 0; i < 3; ++i) {
            problem.state = random_state(dice, contact);
            INFO("seed " << seed << ", state " << i);
            CHECK(wheel_rail_faults(problem, contact.solve(problem.state, observer)).empty());
        }
    }
}

TEST_CASE("A contact that reaches the ends of a profile is solved, and says so") {
    WheelRailSetup setup = cylinder_on_arc(300);
    const double from = GENERATE(-3.0, -30.0), to = from < -10 ? 2.0 : 3.0;
    setup.rail.shape = ArcProfile{300, 0, from, to};
    setup.dx = setup.dy = 0.5;
    WheelRailState state;
    state.Fz = 60000;
    const WheelRailSolution solution = solve(setup, state);
    CHECK(solution.converged());
    REQUIRE(solution.patches.size() == 1);
    CHECK_THAT(solution.warnings.at(0), ContainsSubstring("reaches the end of a profile"));
}

TEST_CASE("Warnings of a patch's solution name the patch") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 3;
    WheelRailState state;
    state.Fz = 1000;
    const WheelRailSolution solution = solve(setup, state);
    REQUIRE_FALSE(solution.patches.at(0).solution.warnings.empty());
    CHECK_THAT(solution.warnings.at(0), ContainsSubstring("The contact at y = 750 mm: "));
    CHECK_THAT(solution.warnings.at(0), ContainsSubstring(solution.patches[0].solution.warnings[0]));
}

TEST_CASE("The search alone finds the contacts that a solve has, near the height that a force brings") {
    WheelRailSetup setup;
    setup.side = GENERATE(Side::left, Side::right);
    setup.dx = setup.dy = 0.4;
    WheelRailState state;
    state.position = {GENERATE(0.0, 5.0, -8.0), 0, 0.001, 0.01};
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 80000;
    const WheelRailContact contact(setup);
    Observer observer;
    const WheelRailSolution solution = contact.solve(state, observer);
    // On a flange friction carries some of the force, which Hertz's theory neglects.
    if (solution.patches.size() == 1 && std::abs(solution.patches[0].place.reference.angle) < 0.5)
        CHECK_THAT(contact.locate(state).z, WithinAbs(solution.z, 5e-3));
    state.Fz.reset();
    state.position.z = solution.z;
    const WheelRailGeometry geometry = contact.locate(state);
    CHECK(geometry.clearance == solution.clearance);
    REQUIRE(geometry.places.size() == solution.patches.size());
    for (std::size_t i = 0; i < geometry.places.size(); ++i) {
        const ContactPlace &found = geometry.places[i], &solved = solution.patches[i].place;
        // Under a force, positions are those of an adjacent height.
        for (double ContactReference::* of : {&ContactReference::y, &ContactReference::z, &ContactReference::angle})
            CHECK_THAT(found.reference.*of, WithinAbs(solved.reference.*of, 1e-3));
        CHECK_THAT(found.approach, WithinRel(solved.approach, 0.1));
        CHECK_THAT(found.creepages.xi, WithinAbs(solved.creepages.xi, 1e-5));
        CHECK_THAT(found.creepages.eta, WithinAbs(solved.creepages.eta, 1e-5));
    }
}

TEST_CASE("A contact of a few elements, which moves by one with each height, carries its force at a height",
          "[wheel_rail]") {
    WheelRailSetup setup = cylinder_on_arc(30);
    setup.rail.shape = ArcProfile{30, 0, -15, 15};
    setup.wheel.shape = ConeProfile{0.025, -40, 40};
    setup.friction = WheelRailFriction{{{0, 0.3}}, false, {}};
    setup.dx = setup.dy = 0.2;
    WheelRailState state;
    state.velocity = {.x = 1000, .pitch = -1000.0 / 450};
    state.Fz = 0.01;
    const WheelRailSolution solution = solve(setup, state);
    CHECK(solution.converged());
    state.position.z = solution.z;
    state.Fz.reset();
    CHECK_THAT(solve(setup, state).forces.track.Fz, WithinRel(0.01, 1e-3));  // which 1e-9 mm change by the same amount
}

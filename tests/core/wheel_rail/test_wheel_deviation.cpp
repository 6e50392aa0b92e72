// Wheels of flexible wheelsets: where they are and how they move beside a rigid wheelset.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/solve_wheel_rail.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

WheelRailSetup coarse_setup(Side side = Side::right) {
    WheelRailSetup setup;
    setup.side = side;
    setup.dx = setup.dy = 1;
    return setup;
}

WheelRailState rolling_state() {
    WheelRailState state;
    state.position.y = 2;
    state.velocity.x = 2000;
    state.velocity.pitch = -2000 / 460.0;
    return state;
}

/// Height at which a wheel presses on its rail.
double pressed(const WheelRailContact& contact, const WheelRailState& state) {
    return contact.first_contact_height(state).value() + 0.06;
}

/// Where the profile's origin is from the centre of a wheelset.
double arm(const WheelRailSetup& setup) {
    return setup.wheelset.flange_back_distance / 2 - setup.wheelset.flange_back_position;
}

void check_same(const WheelRailSolution& one, const WheelRailSolution& other) {
    REQUIRE(one.in_contact());
    REQUIRE(one.patches.size() == other.patches.size());
    for (std::size_t i = 0; i < one.patches.size(); ++i) {
        const ContactPlace &a = one.patches[i].place, &b = other.patches[i].place;
        CHECK_THAT(a.reference.x, WithinAbs(b.reference.x, 1e-9));
        CHECK_THAT(a.reference.y, WithinAbs(b.reference.y, 1e-9));
        CHECK_THAT(a.reference.angle, WithinAbs(b.reference.angle, 1e-9));
        CHECK_THAT(a.approach, WithinAbs(b.approach, 1e-9));
        CHECK_THAT(a.creepages.xi, WithinAbs(b.creepages.xi, 1e-12));
        CHECK_THAT(a.creepages.eta, WithinAbs(b.creepages.eta, 1e-12));
        CHECK_THAT(a.creepages.phi, WithinAbs(b.creepages.phi, 1e-15));
    }
    CHECK_THAT(one.forces.track.Fz, WithinRel(other.forces.track.Fz, 1e-6));
    CHECK_THAT(one.forces.track.Fy, WithinAbs(other.forces.track.Fy, 1e-5 * other.forces.track.Fz));
}

}  // namespace

TEST_CASE("A wheel that is displaced is one of a wheelset that is wider") {
    const Side side = GENERATE(Side::left, Side::right);
    WheelRailState displaced = rolling_state();
    displaced.wheel.y = side == Side::right ? 0.7 : -0.7;
    WheelRailSetup wider = coarse_setup(side);
    wider.wheelset.flange_back_distance += 2 * 0.7;
    WheelRailState state = rolling_state();
    displaced.position.z = state.position.z = pressed(WheelRailContact(wider), state);
    Observer observer;
    const WheelRailSolution one = WheelRailContact(coarse_setup(side)).solve(displaced, observer);
    const WheelRailSolution other = WheelRailContact(wider).solve(state, observer);
    check_same(one, other);
}

TEST_CASE("A wheel that leans with its profile's origin displaced stands as that of a wheelset that rolls") {
    const WheelRailSetup setup = coarse_setup();
    const double angle = 0.01, y = arm(setup), z = setup.wheelset.nominal_radius;
    WheelRailState rolled = rolling_state(), leaning = rolling_state();
    const WheelRailContact contact(setup);
    rolled.position.roll = angle;
    rolled.velocity = {};
    leaning.position.z = rolled.position.z = pressed(contact, rolled);
    leaning.velocity = {};
    leaning.wheel.roll = angle;
    leaning.wheel.y = std::cos(angle) * y - std::sin(angle) * z - y;
    leaning.wheel.z = std::sin(angle) * y + std::cos(angle) * z - z;
    Observer observer;
    check_same(contact.solve(leaning, observer), contact.solve(rolled, observer));
}

TEST_CASE("Rates of a wheel are those of a wheelset about its profile's origin") {
    const WheelRailSetup setup = coarse_setup();
    const double rate = 0.3, y = arm(setup), z = setup.wheelset.nominal_radius;
    WheelRailState rolling = rolling_state(), wheel = rolling_state();
    const WheelRailContact contact(setup);
    rolling.position.z = wheel.position.z = pressed(contact, rolling);
    rolling.velocity.roll = rate;
    wheel.wheel.roll_velocity = rate;
    wheel.wheel.y_velocity = -rate * z;
    wheel.wheel.z_velocity = rate * y;
    Observer observer;
    check_same(contact.solve(wheel, observer), contact.solve(rolling, observer));
}

TEST_CASE("A wheel that is displaced along the track has the forces of a wheelset that is") {
    WheelRailSetup setup = coarse_setup(GENERATE(Side::left, Side::right));
    setup.wheel.shape = ConeProfile{-0.05, -40, 40};
    setup.rail.shape = ArcProfile{300, 0, -30, 30};
    setup.rigid_slip = GENERATE(RigidSlipKind::plane, RigidSlipKind::surfaces, RigidSlipKind::elements);
    setup.conformal = GENERATE(Conformal::off, Conformal::half_space);
    setup.patches.search = GENERATE(ContactSearch::locus, ContactSearch::mesh);
    const bool shifts = GENERATE(true, false);
    if (setup.conformal != Conformal::off && setup.rigid_slip == RigidSlipKind::surfaces) return;
    WheelRailState state;
    state.Fz = 2e4;
    state.position.yaw = 0.002;
    state.velocity = {2000, 3, 0, 0.01, 0.02, -2000 / 460.0};
    if (shifts) {
        state.motion = WheelRailMotion::shift;
        state.time_step = 1e-5;
    }
    WheelRailState displaced = state;
    displaced.wheel.x = 3;
    state.position.y += 3 * std::sin(state.position.yaw);  // along the wheelset's x
    Observer observer;
    const WheelRailSolution there = WheelRailContact(setup).solve(displaced, observer);
    const WheelRailSolution here = WheelRailContact(setup).solve(state, observer);
    REQUIRE(here.in_contact());
    const Wrench &one = there.forces.track, &other = here.forces.track;
    REQUIRE(std::abs(other.Fy) > 100);
    // Elements of shifts are counted along the rail, and lie otherwise in the contact.
    const double off = (shifts ? 5e-3 : 2e-5) * other.Fz;
    CHECK_THAT(one.Fz, WithinRel(other.Fz, 1e-6));
    CHECK_THAT(one.Fx, WithinAbs(other.Fx, off));
    CHECK_THAT(one.Fy, WithinAbs(other.Fy, off));
    CHECK_THAT(there.patches[0].place.reference.x, WithinAbs(here.patches[0].place.reference.x + 3, 0.02));
    CHECK_THAT(there.z, WithinAbs(here.z, 2e-5));
}

TEST_CASE("A wheel that leans touches where one with a rotated profile does") {
    const double angle = 0.02;
    WheelRailSetup rotated = coarse_setup();
    const ProfileCurve curve = make_profile(rotated.wheel).curve;
    std::vector<ProfilePoint> points;
    for (const ProfilePoint& point : curve.points())
        points.push_back({std::cos(angle) * point.y - std::sin(angle) * point.z,
                          std::sin(angle) * point.y + std::cos(angle) * point.z});
    rotated.wheel.shape = ProfilePoints{points};
    WheelRailSetup straight = coarse_setup();
    straight.wheel.shape = ProfilePoints{curve.points()};
    WheelRailState state = rolling_state(), leaning = rolling_state();
    leaning.wheel.roll = angle;
    state.position.z = leaning.position.z = WheelRailContact(rotated).first_contact_height(state).value() + 0.05;
    const WheelRailGeometry one = WheelRailContact(straight).locate(leaning);
    const WheelRailGeometry other = WheelRailContact(rotated).locate(state);
    REQUIRE(one.places.size() == other.places.size());
    REQUIRE(!one.places.empty());
    for (std::size_t i = 0; i < one.places.size(); ++i) {
        CHECK_THAT(one.places[i].reference.y, WithinAbs(other.places[i].reference.y, 1e-6));
        CHECK_THAT(one.places[i].reference.angle, WithinAbs(other.places[i].reference.angle, 1e-6));
        CHECK_THAT(one.places[i].penetration, WithinAbs(other.places[i].penetration, 1e-8));
    }
}

TEST_CASE("Deviations that are degrees are warned of") {
    WheelRailState state = rolling_state();
    state.wheel.roll = 0.3;
    state.Fz = 1e4;
    const WheelRailGeometry geometry = WheelRailContact(coarse_setup()).locate(state);
    bool warns = false;
    for (const std::string& warning : geometry.warnings) warns = warns || warning.starts_with("wheel.roll is 0.3 rad");
    CHECK(warns);
}

// Tests rigid contact of wheelsets against closed forms and the published roll of a benchmark.
#include "contactd/wheelset_contacts.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <random>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "geometry/position.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

ProfileCurve wheel(const ProfileShape& shape) {
    return make_profile({ProfileKind::wheel, shape}).curve;
}
ProfileCurve rail(const ProfileShape& shape) {
    return make_profile({ProfileKind::rail, shape}).curve;
}

/// Places both profiles with their origins above each other.
WheelsetOnTrack aligned(const ProfileShape& wheel_shape, const ProfileShape& rail_shape) {
    const WheelOverRail pair{wheel(wheel_shape), rail(rail_shape), 750, {750, 0}};
    return {pair, pair};
}

}  // namespace

TEST_CASE("wheels of arcs touch arcs where their centres say", "[conicity]") {
    const double Rw = 500, Rr = 300, slope = -0.05, lean = std::atan(0.05);
    const auto wheelset = aligned(ArcProfile{Rw, slope}, ArcProfile{Rr, slope});
    for (const double shift : {0.0, 0.3, -2.0, 6.0}) {
        const auto contacts = contacts_at(wheelset, shift, WheelsetRoll::neglected);
        const auto sine = [&](double outwards) { return std::sin(lean) + outwards * shift / (Rw - Rr); };
        const auto radius = [&](double outwards) {
            return 460 + Rw * (std::cos(lean) - std::cos(std::asin(sine(outwards))));
        };
        CHECK_THAT(contacts.right.radius, WithinAbs(radius(1), 1e-6));
        CHECK_THAT(contacts.left.radius, WithinAbs(radius(-1), 1e-6));
        CHECK_THAT(contacts.right.angle, WithinAbs(-std::asin(sine(1)), 1e-7));
        CHECK_THAT(contacts.left.angle, WithinAbs(std::asin(sine(-1)), 1e-7));
        CHECK_THAT(contacts.right.y, WithinAbs(750 + Rr * (std::sin(lean) - sine(1)), 1e-4));
        CHECK(contacts.roll == 0);
    }
}

TEST_CASE("with roll both wheels touch at one height, and arcs have the conicity of their closed form", "[conicity]") {
    // Evaluates Wickens, Fundamentals of Rail Vehicle Dynamics, to first order in the shift and the angle.
    const double Rw = GENERATE(400., 1000.), Rr = 300, angle = 0.01;
    const auto wheelset = aligned(ArcProfile{Rw, -std::tan(angle)}, ArcProfile{Rr, -std::tan(angle)});
    const auto contacts = contacts_at(wheelset, 0.05);
    CHECK_THAT(contacts.right.height, WithinAbs(contacts.left.height, 1e-9));
    const double half = 750, closed = Rw * angle / (Rw - Rr) * (half + Rr * angle) / (half - 460 * angle);
    CHECK_THAT(contacts.radius_difference() / 0.1, WithinRel(closed, 1e-3));
    CHECK(std::abs(contacts.roll) > 1e-7);
}

TEST_CASE("each wheel has its own radius, and the axle leans towards the smaller one", "[conicity]") {
    const double smaller = GENERATE(0.5, 1.0, -2.0);
    const auto equal = aligned(ConeProfile{-0.05, -60, 60}, ArcProfile{300, 0, -36, 36});
    auto unequal = equal;
    unequal.left.nominal_radius -= smaller;
    for (const double shift : {0.0, 2.0}) {
        const auto plain = contacts_at(equal, shift, WheelsetRoll::neglected);
        const auto contacts = contacts_at(unequal, shift, WheelsetRoll::neglected);
        CHECK(contacts.right == plain.right);
        CHECK(contacts.left.radius == plain.left.radius - smaller);
        CHECK_THAT(contacts.radius_difference(), WithinAbs(plain.radius_difference() + smaller, 1e-9));
    }
    const auto contacts = contacts_at(unequal, 0);
    // A roll about the axle also shifts both cones sideways, which raises one wheel and lowers the other.
    const double arms = contacts.right.y - contacts.left.y - 0.05 * (contacts.right.radius + contacts.left.radius);
    CHECK_THAT(contacts.roll, WithinRel(-smaller / arms, 1e-3));
    CHECK_THAT(contacts.left.height - contacts.right.height, WithinAbs(-smaller, 1e-9));
}

TEST_CASE("a wheelset of S1002 on 60E1 rolls as in the published benchmark", "[conicity]") {
    // The benchmark's roll balances elastic contacts of 10 kN under yaw; rigid ones without yaw have nearly the same
    // roll.
    const auto wheelset = wheelset_on_track(wheel(S1002{}), rail(Rail60E1{1.0 / 40}));
    for (const auto& [shift, roll] : {std::pair(1., -5.049e-5), {2., -1.128e-4}, {3., -1.803e-4}, {4., -2.557e-4}})
        CHECK_THAT(contacts_at(wheelset, shift).roll, WithinAbs(roll, 5e-6));
    for (const auto& [shift, roll] : {std::pair(7., -6.393e-3), {10., -1.126431e-2}})
        CHECK_THAT(contacts_at(wheelset, shift).roll, WithinAbs(roll, 1e-4));
}

TEST_CASE("a wheelset shifted to the left is one shifted to the right in a mirror", "[conicity]") {
    const auto wheelset = wheelset_on_track(wheel(S1002{}), rail(Rail60E1{1.0 / 20}));
    for (const double shift : {0.7, 4.0, 7.5}) {
        const auto right = contacts_at(wheelset, shift), left = contacts_at(wheelset, -shift);
        CHECK_THAT(left.roll, WithinAbs(-right.roll, 1e-12));
        CHECK_THAT(left.left.y, WithinAbs(-right.right.y, 1e-7));
        CHECK_THAT(left.left.angle, WithinAbs(-right.right.angle, 1e-8));
        CHECK_THAT(left.radius_difference(), WithinAbs(-right.radius_difference(), 1e-8));
    }
}

TEST_CASE("contacts are where the tangents of wheel and rail agree", "[conicity]") {
    const auto wheelset = wheelset_on_track(wheel(S1002{}), rail(Rail60E1{1.0 / 40}));
    for (double shift = -8; shift <= 8; shift += 0.37) {
        const auto contacts = contacts_at(wheelset, shift);
        const auto& right = contacts.right;
        CHECK_FALSE(right.at_end);
        CHECK_THAT(wheelset.right.wheel.angle(wheelset.right.wheel.s_at_y(right.wheel_y)) + contacts.roll,
                   WithinAbs(right.angle, 1e-8));
        CHECK_THAT(right.rail_y + wheelset.right.rail_origin.y, WithinAbs(right.y, 1e-9));
    }
}

TEST_CASE("heights are those at which the search for elastic contact finds no distance left", "[conicity]") {
    WheelRailSetup setup;
    const auto wheelset = wheelset_on_track(wheel(S1002{}), rail(Rail60E1{1.0 / 40}));
    const geometry::Profiles profiles = geometry::make_profiles(setup);
    for (const double shift : {-6.0, -1.0, 0.0, 2.5, 5.5, 7.5}) {
        const auto contacts = contacts_at(wheelset, shift);
        WheelRailState state;
        state.position.y = shift;
        state.position.roll = contacts.roll;
        const geometry::Position position(setup, profiles, state);
        CHECK_THAT(position.clearance(0), WithinAbs(contacts.right.height, 1e-4));  // the search goes in steps
    }
}

TEST_CASE("no shift of rough profiles hangs or leaves a contact that is none", "[conicity]") {
    std::mt19937 dice(3);
    std::normal_distribution<double> error(0, 0.01);
    const auto rough = [&](const ProfileSpec& spec) {
        ProfilePoints given;
        const auto curve = make_profile(spec).curve;
        for (double s = 0; s < curve.end(); s += 0.4) {
            given.points.push_back(curve.at(s));
            given.points.back().z += error(dice);
        }
        return make_profile({spec.kind, given}).curve;
    };
    const auto wheelset =
        wheelset_on_track(rough({ProfileKind::wheel, S1002{}}), rough({ProfileKind::rail, Rail60E1{}}));
    std::uniform_real_distribution<double> shifts(-15, 15);
    for (int round = 0; round < 300; ++round) {
        const auto contacts = contacts_at(wheelset, shifts(dice));
        REQUIRE(std::isfinite(contacts.radius_difference()));
        REQUIRE_THAT(contacts.right.height, WithinAbs(contacts.left.height, 1e-8));
        REQUIRE(std::abs(contacts.roll) < 0.05);
    }
}

TEST_CASE("a rail is placed by its gauge, and its cant is an inclination", "[conicity]") {
    const auto curve = rail(Rail60E1{1.0 / 40});
    const auto placed = wheel_over_rail(wheel(S1002{}), curve);
    const double s = curve.s_at_y(1435.0 / 2 - placed.rail_origin.y);
    CHECK_THAT(curve.at(s).z, WithinAbs(14, 2e-3));  // straight lines between the points determine the gauge point
    CHECK(curve.angle(s) < -1);
    CHECK_THAT(wheel_over_rail(wheel(S1002{}), curve, {.gauge = 1445}).rail_origin.y,
               WithinAbs(placed.rail_origin.y + 5, 1e-12));
    const auto inclined = wheelset_on_track(wheel(S1002{}), curve),
               canted = wheelset_on_track(wheel(S1002{}), rail(Rail60E1{}), {.cant = std::atan(1.0 / 40)});
    const auto first = contacts_at(inclined, 2.3), second = contacts_at(canted, 2.3);
    CHECK_THAT(second.right.y, WithinAbs(first.right.y, 2e-3));
    CHECK_THAT(second.right.angle, WithinAbs(first.right.angle, 1e-5));
    CHECK_THAT(second.radius_difference(), WithinAbs(first.radius_difference(), 2e-4));
}

TEST_CASE("a wheelset that does not fit the track is refused", "[conicity]") {
    const auto refused = [](const auto& call, const std::string& what) {
        CHECK_THROWS_MATCHES(call(), InvalidArgument, MessageMatches(ContainsSubstring(what)));
    };
    const auto tread = wheel(S1002{});
    const auto head = rail(Rail60E1{1.0 / 40});
    refused([&] { return wheelset_on_track(tread, head, {.gauge = 50}); },
            "track.gauge is 50, less than the width of a rail");
    refused([&] { return wheelset_on_track(tread, head, {.gauge = std::nan("")}); }, "track.gauge is nan");
    refused([&] { return wheelset_on_track(tread, head, {}, {.nominal_radius = 0}); }, "wheelset.nominal_radius is 0");
    refused([&] { return contacts_at(wheelset_on_track(tread, head, {.gauge = 1000}), 0); },
            "wheel is not above its rail");
    refused([&] { return contacts_at(wheelset_on_track(tread, head), 400); }, "shift is 400");
    refused([&] { return contacts_at(wheelset_on_track(tread, head), std::nan("")); }, "shift is nan");
}

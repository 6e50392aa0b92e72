// Mistakes of users.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("Mistakes in a set-up are refused by name") {
    const auto refused = [](const std::function<void(WheelRailSetup&)>& spoil, const std::string& sentence) {
        WheelRailSetup setup;
        spoil(setup);
        REQUIRE_THROWS_AS(WheelRailContact(setup), InvalidArgument);
        CHECK_THROWS_WITH(WheelRailContact(setup), ContainsSubstring(sentence));
    };
    refused([](auto& setup) { setup.track.gauge = -1435; }, "track.gauge is -1435");
    refused([](auto& setup) { setup.track.gauge = 40; }, "track.gauge is 40");
    refused([](auto& setup) { setup.track.gauge_height = -1; }, "track.gauge_height is -1");
    refused([](auto& setup) { setup.track.cant = 1.4; }, "track.cant is 1.4");
    refused([](auto& setup) { setup.track.roller_leans = true; }, "track.roller_leans is given");
    refused([](auto& setup) { setup.wheelset.nominal_radius = 0; }, "wheelset.nominal_radius is 0");
    refused([](auto& setup) { setup.wheelset.nominal_radius = 2; }, "wheelset.nominal_radius is 2");
    refused([](auto& setup) { setup.wheelset.flange_back_position = 900; }, "wheelset.flange_back_position is 900");
    refused([](auto& setup) { setup.dx = NAN; }, "dx is nan");
    refused([](auto& setup) { setup.dy = 0; }, "dy is 0");
    refused([](auto& setup) { setup.patches.distance_combine = 9; }, "patches.distance_separate is 8");
    refused([](auto& setup) { setup.friction->mu = {}; }, "friction.mu is empty");
    refused([](auto& setup) { setup.friction->mu = {{0, -0.3}}; }, "friction.mu is -0.3");
    refused([](auto& setup) { setup.friction->mu = {{-1, 0.3}, {0, -0.3}}; }, "friction.mu[1].mu is -0.3");
    refused([](auto& setup) { setup.friction->mu = {{0, 0.3}, {-1, 0.3}}; }, "friction.mu[1].angle is -1");
    refused([](auto& setup) { std::swap(setup.wheel, setup.rail); }, "wheel.kind is rail");
    refused([](auto& setup) { setup.rail.shape = ProfilePoints{{{0, 0}}}; }, "rail.points");
    refused([](auto& setup) { setup.bodies.upper.material.G = -1; }, "bodies.upper.G is -1");
    refused([](auto& setup) { setup.bodies.lower.viscoelastic = Viscoelasticity{1, 1}; },
            "bodies.lower.viscoelastic is given");
}

TEST_CASE("A set-up is not valid with a profile that is none") {
    WheelRailSetup setup;
    setup.rail.shape = ArcProfile{.radius = 0};
    CHECK_THROWS_WITH(validate(setup), ContainsSubstring("rail.arc.radius is 0"));
    setup.rail.shape = Rail60E1{};
    setup.wheel_slices = {{0, setup.wheel}, {1, setup.wheel}};
    CHECK_NOTHROW(validate(setup));
    setup.wheel_slices[1].profile.shape = ConeProfile{.slope = 9};
    CHECK_THROWS_WITH(validate(setup), ContainsSubstring("wheel_slices[1].profile.cone.slope is 9"));
}

TEST_CASE("Other units and other sides are refused by a sentence that says what to do") {
    // A user has S1002 on 60E1 at 1/40, by points in mm.
    const auto points_of = [](const ProfileSpec& profile) {
        return ProfilePoints{make_profile(profile).curve.points()};
    };
    WheelRailSetup setup;
    ProfilePoints wheel = points_of(setup.wheel), rail = points_of(setup.rail);
    const auto refused = [&](const std::string& field, const std::string& remedy) {
        setup.wheel.shape = wheel;
        setup.rail.shape = rail;
        CHECK_THROWS_WITH(WheelRailContact(setup), ContainsSubstring(field + " ") && ContainsSubstring(remedy));
    };
    SECTION("profiles in metres, said to be in millimetres") {
        for (ProfilePoint& point : wheel.points) point = {point.y / 1000, point.z / 1000};
        refused("wheel.points", "check their unit");
    }
    SECTION("profiles in millimetres, said to be in metres") {
        rail.unit = 1000;
        refused("rail.points", "check their unit");
    }
    SECTION("a wheel with its flange on the field side") {
        wheel.mirror_y = true;
        refused("wheel.points", "change mirror_y");
    }
    SECTION("a wheel upside down") {
        wheel.mirror_z = true;
        refused("wheel.points", "change mirror_z");
    }
    SECTION("a rail upside down") {
        rail.mirror_z = true;
        refused("rail.points", "change mirror_z");
    }
    SECTION("a rail whose gauge side alone was measured, on the other side") {
        std::erase_if(rail.points, [](const ProfilePoint& point) { return point.y > 10; });
        rail.mirror_y = true;
        refused("track.gauge_height", "change mirror_y");
    }
    SECTION("a track in metres") {
        setup.track = {1.435, 0.014};
        refused("track.gauge_height", "check the unit");
        setup.track.gauge_height = 14;
        refused("track.gauge", "the rails would overlap");
    }
    SECTION("a wheel's radius in metres") {
        setup.wheelset.nominal_radius = 0.46;
        refused("wheelset.nominal_radius", "it must be more than twice that");
    }
    SECTION("an inclination in degrees") {
        setup.track.cant = 1.43;
        refused("track.cant", "rad");
    }
}

TEST_CASE("A state in other units says so in a warning") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    WheelRailState state;
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 60000;
    const auto warned = [&](const std::string& sentence) {
        const WheelRailSolution solution = solve(setup, state);
        REQUIRE_FALSE(solution.warnings.empty());
        CHECK_THAT(solution.warnings.back(), ContainsSubstring(sentence));
    };
    CHECK(solve(setup, state).warnings.empty());
    SECTION("a yaw in degrees") {
        state.position.yaw = 0.3;
        warned(
            "position.yaw is 0.3 rad, but wheelsets on rails rotate by hundredths of a radian. Give angles in rad, not "
            "in "
            "degrees. If it is in degrees, it is 0.005236 rad.");
    }
    SECTION("a rail's roll in degrees") {
        state.rail.roll = -0.2;
        warned("rail.roll is -0.2 rad");
    }
    SECTION("a speed in metres") {
        state.velocity.x = 20;
        warned("velocity.pitch is close to -velocity.x/nominal_radius");
        warned("velocity.x = 20 mm/s fits that rate if it is in m/s: 20 m/s is 20000 mm/s.");
    }
    SECTION("a speed in kilometres per hour") {
        state.velocity.x = 72;
        warned("velocity.x = 72 mm/s fits that rate if it is in km/h: 72 km/h is 20000 mm/s.");
    }
    SECTION("a pitch rate by a radius in metres") {
        state.velocity.pitch *= 1000;
        warned("velocity.pitch = -43400 rad/s fits a nominal_radius in m.");
    }
    SECTION("a speed and a pitch rate of a speed in metres") {
        state.velocity = {20, 0, 0, 0, 0, -0.0434};
        warned(
            "velocity.x is 20 mm/s, slower than vehicles run. Give velocities in mm/s, not in m/s or km/h. If it is in "
            "m/s, it is 20000 mm/s; if in km/h, 5556 mm/s.");
    }
    SECTION("a speed backwards in kilometres per hour, of a wheel that rolls freely") {
        setup.dx = setup.dy = 1;
        state.velocity.x = -200;
        state.Fx = 0;
        warned("velocity.x is -200 mm/s, slower than vehicles run");
    }
    SECTION("a pitch rate with the other sign") {
        state.velocity.pitch = 43.4;
        warned("slides along the rail by");
    }
    SECTION("a position in metres") {
        state.position.y = 0.0061;
        warned("position.y is 0.0061 mm, micrometres from the track centre. Give lengths in mm, not in m.");
    }
    SECTION("a load in kN") {
        state.Fz = 60;
        warned("Fz is 60 N, very small for a wheel of radius 460 mm. Give forces in N, not in kN.");
    }
    SECTION("a distance of the wheels in metres") {
        setup.wheelset.flange_back_distance = 1.36;
        setup.wheelset.flange_back_position = -0.07;
        warned("check position.y, track.gauge, flange_back_distance");
    }
}

TEST_CASE("Slow wheels that are no vehicle's mistake are not warned of") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    WheelRailState state;
    state.Fz = 60000;
    const auto rolls_at = [&](double speed) {
        const double pitch = -speed / setup.wheelset.nominal_radius;
        state.velocity = {setup.track.roller_radius ? 0 : speed, 0, 0, 0, 0, pitch};
        if (setup.track.roller_radius) state.roller_pitch = speed / *setup.track.roller_radius;
    };
    SECTION("that shunt") {
        rolls_at(GENERATE(400.0, 500.0, 1000.0, 3000.0));
    }
    SECTION("at unit speed") {
        rolls_at(1);
    }
    SECTION("on a roller") {
        setup.track.roller_radius = 460;
        rolls_at(GENERATE(10.0, 100.0));
    }
    SECTION("of a model") {
        setup.wheelset.nominal_radius = 100;
        rolls_at(100);
    }
    SECTION("in a shift") {
        rolls_at(100);
        state.motion = WheelRailMotion::shift;
        state.time_step = 1e-3;
    }
    SECTION("that spin where they start") {
        state.velocity = {50, 0, 0, 0, 0, -10};
    }
    SECTION("of a run") {
        rolls_at(20);
        WheelRailEstimates estimates;
        Observer observer;
        CHECK(WheelRailContact(setup).solve(state, estimates, observer).warnings.empty());
        return;
    }
    for (const std::string& warning : solve(setup, state).warnings) {
        CHECK(warning.find("m/s") == warning.find("mm/s") + 1);
        CHECK(warning.find("km/h") == std::string::npos);
        CHECK(warning.find("slower than") == std::string::npos);
    }
}

TEST_CASE("Slices that lie in metres along the track are warned of") {
    WheelRailSetup setup;
    setup.model = Model::hertz;
    setup.friction.reset();
    setup.track.rail_origin = ProfilePoint{760.5, 0};
    WheelRailState state;
    state.Fz = 60000;
    const auto warnings_of = [&](double length, int count, double x) {
        setup.rail_slices.clear();
        for (int i = 0; i < count; ++i) setup.rail_slices.push_back({length * i / (count - 1), setup.rail});
        state.position.x = x;
        std::string all;
        for (const std::string& warning : solve(setup, state).warnings) all += warning + "\n";
        return all;
    };
    CHECK_THAT(warnings_of(0.06, 60, 0.03),
               ContainsSubstring("The distance from rail_slices[0] to the last one is 0.06 mm, less than a contact is "
                                 "long. Give places along the track in mm, not in m. If it is in m, it is 60 mm."));
    CHECK_THAT(
        warnings_of(60, 61, 30000),
        ContainsSubstring("position.x is 30000 mm, beyond rail_slices, which lie from x = 0 to 60 mm and hold 30."));
    CHECK(warnings_of(60, 61, 30) == "");
    CHECK(warnings_of(60, 61, 120000) == "");
    CHECK(warnings_of(60000, 61, 30000) == "");
    CHECK(warnings_of(10000, 101, 20000) == "");  // behind a crossing
    CHECK(warnings_of(60, 2, 0) == "");
}

TEST_CASE("Coefficients of friction in percent are warned of once") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.friction->mu = {{-0.5, 20}, {0.5, 30}};
    WheelRailState state;
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 60000;
    const WheelRailSolution solution = solve(setup, state);
    CHECK(std::ranges::count_if(solution.warnings, [](const std::string& warning) {
              return warning.find(
                         "friction.mu is up to 30, but friction coefficients are below 2. Give it as a ratio, "
                         "not in percent. If it is in percent, it is 0.3.") != std::string::npos;
          }) == 1);
    CHECK(std::ranges::count_if(solution.warnings, [](const std::string& warning) {
              return warning.find("percent") != std::string::npos;
          }) == 1);
}

TEST_CASE("Moduli that no wheel has are warned of once, not for each contact") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    WheelRailState state;
    state.velocity = {20000, 0, 0, 0, 0, -43.4};
    state.Fz = 60000;
    const auto sentences_of = [&](double G) {
        setup.bodies.upper.material = setup.bodies.lower.material = Material{G, 0.28};
        std::vector<std::string> sentences;
        for (const std::string& warning : solve(setup, state).warnings)
            if (warning.find(".G is") != std::string::npos) sentences.push_back(warning);
        return sentences;
    };
    CHECK(sentences_of(82000).empty());
    CHECK(sentences_of(40000).empty());  // cast iron
    REQUIRE(sentences_of(210000).size() == 1);
    CHECK_THAT(sentences_of(210000).front(), ContainsSubstring("Give the shear modulus, not Young's modulus"));
    REQUIRE(sentences_of(8.2e10).size() == 1);
    CHECK_THAT(sentences_of(8.2e10).front(), ContainsSubstring("Give moduli in N/mm^2, not in Pa"));
}

TEST_CASE("Mistakes in a state are refused by name") {
    const WheelRailContact contact(WheelRailSetup{});
    const auto refused = [&](const WheelRailState& state, const std::string& sentence) {
        Observer observer;
        CHECK_THROWS_AS(contact.solve(state, observer), InvalidArgument);
        CHECK_THROWS_WITH(contact.solve(state, observer), ContainsSubstring(sentence));
    };
    WheelRailState state;
    SECTION("a wheel far inside its rail") {
        state.position.z = 10;
        refused(state, "state.position.z is 10, which is 9.");
        refused(state, "lift the wheelset, or prescribe Fz");
    }
    SECTION("degrees") {
        state.position.yaw = 2;
        refused(state, "position.yaw is 2");
    }
    SECTION("a force that pulls") {
        state.Fz = -1e4;
        refused(state, "Fz is -10000");
    }
    SECTION("no number") {
        state.velocity.pitch = NAN;
        refused(state, "velocity.pitch is nan");
    }
}

TEST_CASE("A wheelset that stands still is solved without friction, and says so") {
    WheelRailState state;
    state.Fz = 1e4;
    const WheelRailSolution solution = solve({}, state);
    CHECK(solution.converged());
    REQUIRE(solution.warnings.size() == 1);
    CHECK_THAT(solution.warnings[0], ContainsSubstring("does not roll"));
}

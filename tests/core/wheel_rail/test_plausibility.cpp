// Tests warnings for set-ups that can be solved but are probably mistakes.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <string>

#include "contactd/make_profile.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;

namespace {

ProfilePoints points_of(const ProfileSpec& profile) {
    return ProfilePoints{make_profile(profile).curve.points()};
}

/// Returns the warnings of a solve under Fz, joined.
std::string warnings_of(const WheelRailSetup& setup, double y = 0) {
    Observer observer;
    std::string all;
    for (const std::string& warning : WheelRailContact(setup).solve(loaded_at(y), observer).warnings)
        all += warning + "\n";
    return all;
}

}  // namespace

TEST_CASE("A usual wheel on a usual rail is warned of nothing, across the track") {
    WheelRailSetup setup = frictionless_hertz();
    SECTION("by formulae") {}
    SECTION("by points") {
        setup.wheel.shape = points_of(setup.wheel);
        setup.rail.shape = points_of(setup.rail);
    }
    for (const double y : {-4.0, 0.0, 4.0}) CHECK(warnings_of(setup, y) == "");
}

TEST_CASE("Points in inches are warned of") {
    WheelRailSetup setup = frictionless_hertz();
    setup.track.rail_origin = ProfilePoint{750, 0};
    const auto shrunk = [](const ProfileSpec& profile) {
        ProfilePoints points = points_of(profile);
        for (ProfilePoint& point : points.points) point = {point.y / 25.4, point.z / 25.4};
        return points;
    };
    SECTION("of a wheel") {
        setup.wheel.shape = shrunk(setup.wheel);
        CHECK_THAT(warnings_of(setup),
                   ContainsSubstring("profile of the wheel is 5.") && ContainsSubstring("unit to 25.4"));
    }
    SECTION("of a rail") {
        setup.rail.shape = shrunk(setup.rail);
        CHECK_THAT(warnings_of(setup),
                   ContainsSubstring("profile of the rail is 2.") && ContainsSubstring("unit to 25.4"));
    }
}

TEST_CASE("Dense points that are rounded are warned of, until they are smoothed") {
    WheelRailSetup setup = frictionless_hertz();
    ProfilePoints points;
    for (double y = -36; y <= 36; y += 0.25) points.points.push_back({y, std::round(y * y / 6) / 100});
    setup.rail.shape = points;
    setup.track.rail_origin = ProfilePoint{750, 0};
    CHECK_THAT(warnings_of(setup), ContainsSubstring("points of the rail are rounded to 0.01 and 0.25") &&
                                       ContainsSubstring("smoothing_length"));
    points.smoothing_length = 5;
    setup.rail.shape = points;
    CHECK(warnings_of(setup).find("rounded") == std::string::npos);
}

TEST_CASE("Smoothing that takes away the shape of a profile is warned of") {
    WheelRailSetup setup = frictionless_hertz();
    ProfilePoints points = points_of(setup.wheel);
    const auto warnings_at = [&](double length) {
        points.smoothing_length = length;
        setup.wheel.shape = points;
        return warnings_of(setup);
    };
    CHECK(warnings_at(5).find("Smoothing") == std::string::npos);
    CHECK_THAT(warnings_at(40), ContainsSubstring("Smoothing has moved points of the wheel by up to 2.") &&
                                    ContainsSubstring("smoothing_length 40 mm"));
}

TEST_CASE("The back of a flange that lies nowhere on the wheel is warned of") {
    WheelRailSetup setup = frictionless_hertz();
    setup.wheelset.flange_back_position = -30;
    CHECK_THAT(warnings_of(setup), ContainsSubstring("wheelset.flange_back_position is -30"));
}

TEST_CASE("A wheel that runs on the tip of its flange is warned of") {
    WheelRailSetup setup = frictionless_hertz();
    setup.track.rail_origin = ProfilePoint{694, 0};  // as if the gauge were narrower by the width of a flange
    CHECK_THAT(warnings_of(setup), ContainsSubstring("tip or the back of the wheel's flange"));
}

TEST_CASE("A rail with its gauge side at y > 0 is warned of, until mirror_y turns it") {
    WheelRailSetup setup = frictionless_hertz();
    ProfilePoints points;
    for (const ProfilePoint& point : points_of({ProfileKind::rail, Rail60E1{GENERATE(1.0 / 40, 1.0 / 20)}}).points)
        points.points.insert(points.points.begin(), {-point.y, point.z});
    const auto as_given = [&] {
        setup.rail.shape = points;
        setup.rail_slices.clear();
        if (!setup.track.rail_origin) return;
        for (const double x : {-100.0, 0.0, 100.0}) setup.rail_slices.push_back({x, setup.rail});
    };
    setup.side = GENERATE(Side::left, Side::right);
    SECTION("uniform") {}
    SECTION("by slices") {
        setup.track.rail_origin = ProfilePoint{750, 0};
    }
    as_given();
    CHECK_THAT(warnings_of(setup), ContainsSubstring("gauge side at y > 0") && ContainsSubstring("mirror_y"));
    points.mirror_y = true;
    as_given();
    CHECK(warnings_of(setup).find("gauge side") == std::string::npos);
}

TEST_CASE("A rail that is measured down to the gauge at y > 0 only is warned of") {
    WheelRailSetup setup = frictionless_hertz();
    setup.track.rail_origin = ProfilePoint{750, 0};
    ProfilePoints points = points_of({ProfileKind::rail, Rail60E1{0}});
    const bool right = GENERATE(true, false);
    std::erase_if(points.points, [&](const ProfilePoint& point) { return (right ? -point.y : point.y) > 28; });
    setup.rail.shape = points;
    CHECK((warnings_of(setup).find("gauge side at y > 0") != std::string::npos) == right);
}

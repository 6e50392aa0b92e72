// Tests profiles, slices and friction with too few values for the contact.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "contactd/make_profile.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string thin_warnings(const WheelRailSetup& setup, const WheelRailState& state = loaded_at()) {
    std::string all;
    for (const std::string& warning : solve(setup, state).warnings)
        if (warning.find("apart") != std::string::npos || warning.find("uncertain") != std::string::npos)
            all += warning + "\n";
    return all;
}

WheelRailSetup cylinder() {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.model = Model::hertz;
    return setup;
}

/// Returns points of a curve at about this distance.
ProfilePoints points_of(const ProfileSpec& profile, double apart) {
    const ProfileCurve curve = make_profile(profile).curve;
    ProfilePoints points;
    const int count = static_cast<int>(std::ceil(curve.end() / apart));
    for (int i = 0; i <= count; ++i) points.points.push_back(curve.at(curve.end() * i / count));
    return points;
}

/// Creates a cylinder on an arc of 300 mm whose height varies along the track.
template <class Height>
WheelRailSetup sliced(double apart, const Height& height) {
    WheelRailSetup setup = cylinder();
    ProfilePoints arc = points_of(setup.rail, 1);
    for (int i = -5; i <= 5; ++i) {
        ProfilePoints moved = arc;
        for (ProfilePoint& point : moved.points) point.z += height(i * apart);
        setup.rail_slices.push_back({i * apart, {ProfileKind::rail, moved}});
    }
    return setup;
}

}  // namespace

TEST_CASE("A rail of few points is warned of, of which the contact lies between two") {
    WheelRailSetup setup = frictionless_hertz();
    setup.side = GENERATE(Side::left, Side::right);
    setup.track.rail_origin = ProfilePoint{750, 0};
    const ProfileSpec rail = setup.rail;
    setup.rail.shape = points_of(rail, 18);
    CHECK_THAT(thin_warnings(setup),
               ContainsSubstring("points of the rail are 16") && ContainsSubstring("Give points at most"));
    setup.rail.shape = points_of(rail, 1);
    CHECK(thin_warnings(setup) == "");
}

TEST_CASE("A wheel of few points is warned of where it bends, and not where it is straight") {
    WheelRailSetup setup = frictionless_hertz();
    setup.wheel.shape = points_of(setup.wheel, 25);
    setup.wheelset.flange_back_position = -70;
    CHECK_THAT(thin_warnings(setup), ContainsSubstring("points of the wheel are 2"));
    setup.wheel.shape = ProfilePoints{{{-40, 2}, {40, -2}}};
    CHECK(thin_warnings(setup) == "");
}

TEST_CASE("Slices between which a rail bends by more than the overlap are warned of") {
    const auto wave = [](double length) {
        return [=](double x) { return std::cos(2 * std::numbers::pi * x / length); };
    };
    // Between neighbours it curves by (2 pi/1000)^2 200^2/8 = 0.2 mm, and with slices at 20 mm by 0.002 mm.
    CHECK_THAT(thin_warnings(sliced(200, wave(1000))),
               ContainsSubstring("slices that are 200 mm apart, and the height of the rail"));
    CHECK(thin_warnings(sliced(20, wave(1000))) == "");
    CHECK(thin_warnings(sliced(200, [](double x) { return 0.01 * x; })) == "");
}

TEST_CASE("Slices between which a wheel's radius bends by more than the overlap are warned of") {
    const auto out_of_round = [](int slices) {
        WheelRailSetup setup = cylinder();
        for (int i = 0; i < slices; ++i) {
            const double angle = 2 * std::numbers::pi * i / slices, deeper = std::cos(10 * angle);
            setup.wheel_slices.push_back({angle, {ProfileKind::wheel, ProfilePoints{{{-40, deeper}, {40, deeper}}}}});
        }
        return setup;
    };
    CHECK_THAT(thin_warnings(out_of_round(30)),
               ContainsSubstring("slices that are 94.2 mm apart, and the radius of the wheel"));
    CHECK(thin_warnings(out_of_round(300)) == "");
}

TEST_CASE("Coefficients of friction far apart are warned of where a contact lies between them") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 1;
    const auto warnings = [&](std::vector<FrictionAtAngle> mu) {
        setup.friction = WheelRailFriction{};
        setup.friction->mu = std::move(mu);
        WheelRailState state = loaded_at(7);
        state.velocity.x = 20e3;
        state.velocity.pitch = -20e3 / 460;
        return thin_warnings(setup, state);
    };
    CHECK_THAT(warnings({{-1.2, 0.1}, {0, 0.5}}), ContainsSubstring("between friction coefficients of 0.1 at -1.2"));
    CHECK(warnings({{-1.2, 0.1}, {-0.3, 0.1}, {-0.1, 0.5}}) == "");
}

TEST_CASE("Laws of friction by temperature far apart are warned of where a contact lies between them") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 1;
    setup.temperature = ThermalBodies{};
    const auto warnings = [&](std::vector<TemperatureFrictionAtAngle> laws) {
        setup.friction = WheelRailFriction{};
        setup.friction->temperature_by_angle = std::move(laws);
        WheelRailState state = loaded_at(7);
        state.velocity.x = 20e3;
        state.velocity.pitch = -20e3 / 460;
        return thin_warnings(setup, state);
    };
    // The coefficient of one law falls by 0.2 at 300 degrees, that of the other does not yet; elsewhere both fall
    // alike.
    CHECK_THAT(warnings({{-1.2, -0.2, 100, 200}, {0, -0.2, 300, 200}}),
               ContainsSubstring(
                   "between laws of temperature-dependent friction at -1.2 and 0 rad that differ by 0.2 at 300"));
    CHECK(warnings({{-1.2, -0.2, 100, 200}, {0, -0.15, 100, 200}}) == "");
    CHECK(warnings({{-1.2, -0.2, 100, 200}, {-0.3, -0.2, 100, 200}, {-0.1, -0.2, 300, 200}}) == "");
}

TEST_CASE("Rows that take friction by their own angles are warned of by any of these") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.conformal = Conformal::half_space;
    WheelRailState state = loaded_at(5.5);
    state.velocity.x = 20e3;
    state.velocity.pitch = -20e3 / 460;
    setup.friction = WheelRailFriction{};
    const ContactPlace place = solve(setup, state).patches.front().place;
    REQUIRE(place.rows.size() > 8);
    const auto [least, largest] = std::minmax(place.rows.front().angle, place.rows.back().angle);
    const double middle = 0.5 * (place.rows[place.rows.size() / 2].angle + least);
    // The middle lies in the dense part of the table, but the steepest rows do not.
    setup.friction->mu = {{least - 0.4, 0.1}, {middle, 0.5}, {largest + 0.01, 0.5}};
    CHECK(thin_warnings(setup, state) == "");
    setup.friction->along_profile = true;
    CHECK_THAT(thin_warnings(setup, state), ContainsSubstring("Give friction.mu at more angles."));
}

// Tests wheels that climb on their flanges or roll on the ends of their treads, and states without a load.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::string off_tread(const WheelRailSolution& solution) {
    for (const std::string& warning : solution.warnings)
        if (warning.starts_with("The wheel ")) return warning;
    return "";
}

/// Returns the number after a part of a sentence.
double behind(const std::string& sentence, const std::string& text) {
    return std::stod(sentence.substr(sentence.find(text) + text.size()));
}

}  // namespace

TEST_CASE("A wheel that climbs on its flange is named with Fy/Fz and the height of its tread") {
    WheelRailSetup setup = frictionless_hertz();
    setup.side = GENERATE(Side::right, Side::left);
    const double y = GENERATE(7.2, 8.0, 12.0, 18.0);
    const WheelRailSolution solution = solve(setup, loaded_at(setup.side == Side::left ? -y : y));
    REQUIRE(solution.patches.size() == 1);
    const std::string warning = off_tread(solution);
    REQUIRE_THAT(warning, ContainsSubstring("climbs on its flange"));
    // Without friction the force is normal to the contact.
    CHECK_THAT(behind(warning, "Fy/Fz = "),
               WithinRel(std::abs(std::tan(solution.patches[0].place.reference.angle)), 0.02));
    // A wheel without a flange touches at this height.
    ProfilePoints tread;
    const Profile whole = make_profile(setup.wheel);
    for (const ProfilePoint& point : whole.curve.points())
        if (point.y > whole.evidence.wheel->throat.y + 10) tread.points.push_back(point);
    setup.wheel.shape = tread;
    setup.wheelset.flange_back_position = -70;
    const auto touches = WheelRailContact(setup).first_contact_height(loaded_at(setup.side == Side::left ? -y : y));
    CHECK_THAT(behind(warning, "tread is "), WithinAbs(*touches - solution.z, 0.1));
}

TEST_CASE("A wheel that runs in its throat, or touches with flange and tread, is not said to climb") {
    for (const double y : {-6.0, 0.0, 4.0, 5.5, 6.5}) CHECK(off_tread(solve(frictionless_hertz(), loaded_at(y))) == "");
}

TEST_CASE("A wheel that rolls on the end of its tread is named") {
    WheelRailSetup setup = frictionless_hertz();
    setup.side = GENERATE(Side::right, Side::left);
    const WheelRailSolution solution = solve(setup, loaded_at(setup.side == Side::left ? 50 : -50));
    const std::string warning = off_tread(solution);
    REQUIRE_THAT(warning, ContainsSubstring("rolls on the end of its tread") && ContainsSubstring("Fy/Fz = "));
    // The S1002 ends at y = 60 with z = 1.364 - y/15.
    const double from_end = behind(warning, "tread, ");
    CHECK_THAT(behind(warning, "contact is "), WithinAbs((60 - from_end) / 15 - 1.364, 0.05));
}

TEST_CASE("A state without a force and without a height is refused, and one with a height of zero is solved") {
    const WheelRailSetup setup = frictionless_hertz();
    WheelRailState state;
    const auto refused = Catch::Matchers::Message(
        "state.Fz is missing, and so is position.z; give the vertical force Fz (N), or the height position.z (mm)");
    CHECK_THROWS_MATCHES(solve(setup, state), InvalidArgument, refused);
    WheelRailEstimates estimates;
    Observer observer;
    CHECK_THROWS_MATCHES(WheelRailContact(setup).solve(state, estimates, observer), InvalidArgument, refused);
    state.position.z = 0;
    CHECK(solve(setup, state).z == 0);
    // A search for contacts without a load uses the wheel at z = 0.
    state.position.z.reset();
    CHECK(WheelRailContact(setup).locate(state).z == 0);
}

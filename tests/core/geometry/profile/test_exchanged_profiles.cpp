// Tests that profiles of wheel and rail are not taken for each other.
#include "geometry/profile/exchanged_profiles.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <vector>

#include "contactd/make_profile.hpp"
#include "geometry/profile/formula_points.hpp"

using namespace contactd;
using geometry::formula_points;
using geometry::has_shape_of_rail;
using geometry::has_shape_of_wheel;

namespace {

ProfileCurve upside_down(std::vector<ProfilePoint> points) {
    for (ProfilePoint& point : points) point.z = -point.z;
    return ProfileCurve(points);
}

}  // namespace

TEST_CASE("Standard profiles have their own shapes upright, and the other ones upside down", "[profile]") {
    const auto rail = GENERATE(StandardName::UIC60, StandardName::n49E5, StandardName::n54E1, StandardName::n60E2);
    const double inclination = GENERATE(0.0, 0.025, 0.05);
    const auto head = formula_points(StandardProfile{rail, inclination});
    CHECK_FALSE(has_shape_of_wheel(ProfileCurve(head)));
    CHECK(has_shape_of_rail(upside_down(head)));
    const auto wheel = formula_points(S1002{});
    CHECK_FALSE(has_shape_of_rail(ProfileCurve(wheel)));
    CHECK(has_shape_of_wheel(upside_down(wheel)));
}

TEST_CASE("Crowned discs and noses beside wing rails are not exchanged", "[profile]") {
    const double radius = GENERATE(25.0, 60.0, 100.0);
    std::vector<ProfilePoint> disc;
    for (double y = -0.95 * radius; y <= 0.95 * radius; y += radius / 100)
        disc.push_back({y, std::sqrt(radius * radius - y * y) - radius});
    CHECK_FALSE(has_shape_of_rail(ProfileCurve(disc)));
    const std::vector<ProfilePoint> nose{{-90, 1}, {-50, 0}, {-48, 40}, {-12, 40}, {-10, 2},
                                         {10, 2},  {12, 40}, {48, 40},  {50, 0},   {90, 1}};
    CHECK_FALSE(has_shape_of_wheel(ProfileCurve(nose)));
}

TEST_CASE("Exchanged profiles are warned of", "[profile]") {
    ProfilePoints hanging{formula_points(S1002{})};
    hanging.mirror_z = true;
    const auto warnings = make_profile({ProfileKind::rail, hanging}).evidence.warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings.front() ==
          "The profile of the rail has the shape of a wheel with its flange upwards. Check whether the profiles of "
          "wheel and rail are exchanged.");
}

// Tests tip, throat and tread of wheels.
#include "geometry/profile/wheel_landmarks.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/make_profile.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

TEST_CASE("S1002 has its flange where the standard draws it", "[profile]") {
    const auto found = geometry::wheel_landmarks(make_profile({ProfileKind::wheel, S1002{}}).curve);
    REQUIRE(found);
    CHECK_THAT(found->tip.z, WithinAbs(28, 0.01));
    CHECK_THAT(found->tip.y, WithinAbs(-55, 0.5));
    CHECK_THAT(found->tread.y, WithinAbs(found->tip.y + 55, 1e-6));
    CHECK_THAT(found->tread.z, WithinAbs(0, 0.05));
    // The throat is an arc of 13 mm from y = -38.4 to -26, deepest at the flank.
    CHECK(found->throat.y > -40);
    CHECK(found->throat.y < -26);
    CHECK(found->throat.z < found->tip.z);
    CHECK(found->throat.z > found->tread.z);
}

TEST_CASE("what has no flange has no such places", "[profile]") {
    for (const ProfileShape& shape :
         {ProfileShape{ConeProfile{-0.05}}, ProfileShape{ArcProfile{-330}}, ProfileShape{ConeProfile{-0.4}}})
        CHECK_FALSE(geometry::wheel_landmarks(make_profile({ProfileKind::wheel, shape}).curve));
}

TEST_CASE("a wheel's places follow it when it is moved, worn and scattered", "[profile]") {
    const ProfileCurve exact = make_profile({ProfileKind::wheel, S1002{}}).curve;
    const auto expected = geometry::wheel_landmarks(exact);
    std::vector<ProfilePoint> points;
    for (double s = 0; s < exact.end(); s += 0.3) {
        const ProfilePoint at = exact.at(s);
        const double worn = 2 * std::exp(-std::pow((at.y + 5) / 15, 2));  // a hollow tread
        points.push_back({at.y + 70, at.z - worn + 1e-3 * std::sin(1000 * s)});
    }
    const auto found = geometry::wheel_landmarks(make_profile({ProfileKind::wheel, ProfilePoints{points}}).curve);
    REQUIRE(found);
    CHECK_THAT(found->tip.y, WithinAbs(expected->tip.y + 70, 0.5));
    CHECK_THAT(found->tip.z, WithinAbs(expected->tip.z, 5e-3));
    CHECK_THAT(found->throat.y, WithinAbs(expected->throat.y + 70, 2));
    CHECK_THAT(found->tread.z, WithinAbs(-2 * std::exp(-1. / 9), 0.1));
}

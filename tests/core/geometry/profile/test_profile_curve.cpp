// Tests the curve through the points of a profile.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/profile.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double pi = std::numbers::pi;

/// Creates a rail-like arc of radius R below the top, from -60 to 60 degrees.
std::vector<ProfilePoint> arc(double R, int count) {
    std::vector<ProfilePoint> points;
    for (int i = 0; i < count; ++i) {
        const double angle = pi / 3 * (2.0 * i / (count - 1) - 1);
        points.push_back({R * std::sin(angle), R - R * std::cos(angle)});
    }
    return points;
}

/// Uses uneven steps, and a curvature that changes its sign.
std::vector<ProfilePoint> wave() {
    std::vector<ProfilePoint> points;
    for (int i = 0; i <= 40; ++i) {
        const double y = i + 0.3 * std::sin(3.0 * i);
        points.push_back({y, 2 * std::sin(y / 5)});
    }
    return points;
}

}  // namespace

TEST_CASE("a curve goes through its points at their knots", "[profile]") {
    const ProfileCurve curve(wave());
    REQUIRE(curve.knots().size() == 41);
    CHECK(curve.knots().front() == curve.begin());
    CHECK(curve.knots().back() == curve.end());
    for (std::size_t i = 0; i < curve.points().size(); ++i) {
        CHECK_THAT(curve.at(curve.knots()[i]).y, WithinAbs(curve.points()[i].y, 1e-13));
        CHECK_THAT(curve.at(curve.knots()[i]).z, WithinAbs(curve.points()[i].z, 1e-13));
    }
}

TEST_CASE("a curve is smooth at its points, and its derivatives are those of the curve", "[profile]") {
    const ProfileCurve curve(wave());
    const double step = 1e-5;
    for (std::size_t i = 1; i + 1 < curve.knots().size(); ++i) {
        const double s = curve.knots()[i];
        CHECK_THAT(curve.curving(s - 1e-12).z, WithinAbs(curve.curving(s).z, 1e-10));
        CHECK_THAT((curve.at(s + step).z - curve.at(s - step).z) / (2 * step), WithinAbs(curve.slope(s).z, 1e-9));
        CHECK_THAT((curve.slope(s + step).y - curve.slope(s - step).y) / (2 * step),
                   WithinAbs(curve.curving(s).y, 1e-5));
    }
    CHECK_THAT(curve.curving(0).z, WithinAbs(0, 1e-15));
}

TEST_CASE("the curve of an arc has its angle, curvature and length", "[profile]") {
    const double R = 80;
    const ProfileCurve curve(arc(R, 201));
    const double middle = curve.end() / 2;
    CHECK_THAT(curve.angle(middle), WithinAbs(0, 1e-12));
    CHECK_THAT(curve.curvature(middle), WithinAbs(1 / R, 1e-6));
    CHECK_THAT(curve.mirrored().curvature(middle), WithinAbs(1 / R, 1e-6));
    CHECK_THAT(curve.angle(0.75 * curve.end()), WithinAbs(pi / 6, 1e-8));
    CHECK_THAT(curve.arc_length(curve.end()), WithinAbs(2 * pi / 3 * R, 1e-5));
    CHECK_THAT(curve.arc_length(middle), WithinAbs(pi / 3 * R, 1e-5));
}

TEST_CASE("parameters are found by arc length and by y", "[profile]") {
    const ProfileCurve curve(wave());
    const ProfileCurve backwards(std::vector<ProfilePoint>(curve.points().rbegin(), curve.points().rend()));
    CHECK(backwards.y_is_monotone());
    for (int k = 0; k <= 1000; ++k) {
        const double s = curve.end() * k / 1000;
        CHECK_THAT(curve.s_at_arc_length(curve.arc_length(s)), WithinAbs(s, 1e-11));
        CHECK_THAT(curve.s_at_y(curve.at(s).y), WithinAbs(s, 1e-11));
        CHECK_THAT(backwards.s_at_y(backwards.at(s).y), WithinAbs(s, 1e-11));
    }
    CHECK(curve.s_at_y(-1) == curve.begin());
    CHECK(curve.s_at_y(100) == curve.end());
    CHECK(backwards.s_at_y(-1) == backwards.end());
    CHECK(std::isnan(curve.s_at_y(std::numeric_limits<double>::quiet_NaN())));
}

TEST_CASE("on a curve that turns back the first place with a y is found", "[profile]") {
    const ProfileCurve hook({{0, 0}, {1, 0}, {2, 0.5}, {2.2, 1}, {2, 1.5}, {1, 2}});
    CHECK_FALSE(hook.y_is_monotone());
    const double s = hook.s_at_y(1.5);
    CHECK_THAT(hook.at(s).y, WithinAbs(1.5, 1e-12));
    CHECK(hook.at(s).z < 0.5);
    CHECK(hook.s_at_y(5) == hook.knots()[3]);
    CHECK(hook.s_at_y(-5) == 0);
}

TEST_CASE("a curve is found by y where it stands upright", "[profile]") {
    std::vector<ProfilePoint> points;  // a quarter of a circle, upright at its end
    for (int i = 0; i <= 50; ++i) points.push_back({20 * std::sin(pi * i / 100), -20 * std::cos(pi * i / 100)});
    const ProfileCurve curve(points);
    for (const double y : {19.9, 19.999, 19.999999}) CHECK_THAT(curve.at(curve.s_at_y(y)).y, WithinAbs(y, 1e-12));
}

TEST_CASE("an upright line has its places, too", "[profile]") {
    const ProfileCurve upright({{0, 0}, {5e-324, 1}, {1e-323, 2}});
    CHECK_FALSE(upright.y_is_monotone());
    CHECK(upright.s_at_y(1) == 0);  // all points are at the same distance
    CHECK(upright.s_at_y(-1) == 0);
    CHECK_THAT(upright.angle(0.5), WithinAbs(pi / 2, 1e-15));
}

TEST_CASE("a curve breaks at its kinks", "[profile]") {
    const ProfileCurve roof({{0, 1}, {1, 0.5}, {2, 0}, {3, 0.5}, {4, 1}}, {2});
    const double kink = roof.knots()[2];
    CHECK_THAT(roof.angle(kink - 1e-9), WithinAbs(-std::atan(0.5), 1e-12));
    CHECK_THAT(roof.angle(kink), WithinAbs(std::atan(0.5), 1e-12));
    CHECK_THAT(roof.at(kink).z, WithinAbs(0, 1e-15));
    CHECK_THAT(roof.at(1.3 * kink).z, WithinAbs(0.3, 1e-12));  // both parts are straight
    const ProfileCurve smooth(roof.points());
    CHECK_THAT(smooth.angle(kink), WithinAbs(0, 1e-12));
}

TEST_CASE("a curve goes on as its tangent", "[profile]") {
    const ProfileCurve curve(wave());
    const auto last = curve.place(curve.end());
    const auto beyond = curve.place(curve.end() + 3);
    CHECK_THAT(beyond.at.z, WithinAbs(last.at.z + 3 * last.slope.z, 1e-12));
    CHECK(beyond.slope == last.slope);
    CHECK_THAT(curve.at(-2).y, WithinAbs(curve.points()[0].y - 2 * curve.slope(0).y, 1e-12));
    CHECK_THAT(curve.s_at_arc_length(curve.arc_length(-2)), WithinAbs(-2, 1e-12));
    CHECK_THAT(curve.s_at_arc_length(curve.arc_length(curve.end() + 2)), WithinAbs(curve.end() + 2, 1e-12));
    CHECK(std::isnan(curve.at(std::numeric_limits<double>::quiet_NaN()).y));
}

TEST_CASE("a mirrored curve has the other sign of y, and its kinks", "[profile]") {
    const ProfileCurve curve({{0, 1}, {1, 0.5}, {3, 0}, {4, 0.5}, {5, 0.9}, {6, 1}}, {2});
    const ProfileCurve mirrored = curve.mirrored();
    CHECK(mirrored.kinks() == std::vector<std::size_t>{3});
    for (int k = 0; k <= 100; ++k) {
        const double s = curve.end() * k / 100;
        CHECK_THAT(mirrored.at(curve.end() - s).y, WithinAbs(-curve.at(s).y, 1e-12));
        CHECK_THAT(mirrored.at(curve.end() - s).z, WithinAbs(curve.at(s).z, 1e-12));
    }
    CHECK(mirrored.mirrored().points() == curve.points());
}

TEST_CASE("points that make no curve are refused", "[profile]") {
    const auto refusal = [](const std::string& what) { return MessageMatches(ContainsSubstring(what)); };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_MATCHES(ProfileCurve({}), InvalidArgument,
                         refusal("points has 0 entries; a profile needs at least two"));
    CHECK_THROWS_MATCHES(ProfileCurve({{1, 2}}), InvalidArgument,
                         refusal("points has 1 entries; a profile needs at least two"));
    CHECK_THROWS_MATCHES(ProfileCurve({{1, 2}, {3, nan}}), InvalidArgument,
                         refusal("points[1] has the coordinate nan"));
    CHECK_THROWS_MATCHES(ProfileCurve({{infinity, 2}, {3, 4}}), InvalidArgument, refusal("points[0] has"));
    CHECK_THROWS_MATCHES(ProfileCurve({{0, 0}, {1e6, 0}}), InvalidArgument, refusal("at most 1e5 mm"));
    CHECK_THROWS_MATCHES(ProfileCurve({{0, 0}, {1, 1}, {1, 1}}), InvalidArgument,
                         refusal("points[2] equals the previous point"));
    const std::vector<ProfilePoint> four{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
    CHECK_THROWS_MATCHES(ProfileCurve(four, {0}), InvalidArgument, refusal("kinks[0] is 0; it must be the index"));
    CHECK_THROWS_MATCHES(ProfileCurve(four, {3}), InvalidArgument, refusal("1 to 2"));
    CHECK_THROWS_MATCHES(ProfileCurve(four, {2, 1}), InvalidArgument, refusal("kinks[1] is 1 after 2"));
    CHECK_THROWS_MATCHES(ProfileCurve({{0, 0}, {1, 0}}, {1}), InvalidArgument, refusal("kinks[0] is 1"));
}

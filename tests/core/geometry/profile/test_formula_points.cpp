// Tests profiles by formulas against the formulas and published points.
#include "geometry/profile/formula_points.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "contactd/profile.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using geometry::formula_points;

namespace {

/// Returns the distance of a curve from a point (mm).
double distance(const ProfileCurve& curve, const ProfilePoint& point) {
    double s = curve.knots().front(), least = 1e9;
    for (const double knot : curve.knots()) {
        const auto at = curve.at(knot);
        if (const double far = std::hypot(at.y - point.y, at.z - point.z); far < least) least = far, s = knot;
    }
    for (int iteration = 0; iteration < 50; ++iteration) {
        const auto here = curve.place(s);
        s += (point.y - here.at.y) * here.slope.y + (point.z - here.at.z) * here.slope.z;
    }
    const auto at = curve.at(s);
    return std::hypot(at.y - point.y, at.z - point.z);
}

/// EN 13715, piece by piece.
double s1002(double y) {
    const auto arc = [&](double R, double y0) { return std::sqrt(std::max(0.0, R * R - (y - y0) * (y - y0))); };
    const auto powers = [&](const auto& c) {
        double z = 0;
        for (std::size_t i = c.size(); i-- > 0;) z = z * y + c[i];
        return z;
    };
    if (y > 32.15796) return 1.364323640 - 0.066666667 * y;
    if (y > -26)
        return powers(std::array{0., -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8, -1.562379023e-8,
                                 5.309217349e-15, -5.957839843e-12, 2.646656573e-13});
    if (y > -35)
        return powers(std::array{-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875, -2.054332446e-1,
                                 -4.169739389e-3, -4.687195829e-5, -2.252755540e-7});
    if (y > -38.42666) return 16.446 - arc(13, -26.210665);
    if (y > -39.76447) return -93.576667419 - 2.747477419 * y;
    if (y > -49.66251) return 8.834924130 + arc(20, -58.558326413);
    if (y > -62.76471) return 16 + arc(12, -55);
    return 9.519259302 + arc(20.5, -49.5);
}

}  // namespace

TEST_CASE("the wheel S1002 meets its published points", "[profile]") {
    const ProfileCurve wheel(formula_points(S1002{}));
    const std::vector<ProfilePoint> published{{-68.83788, 16.323393}, {-61.86519, 25.842215}, {-54.11775, 27.967524},
                                              {-45.98294, 24.386760}, {-39.73942, 15.606505}, {-38.96219, 13.471078},
                                              {-37.99293, 10.952521}, {-36.04339, 7.942028},  {-30.08359, 3.952672},
                                              {-25.89688, 2.716230},  {-15.09672, 0.977630},  {-5.06471, 0.214004},
                                              {0.08761, -0.002930},   {9.83296, -0.206501},   {20.17749, -0.314512},
                                              {30.01743, -0.647217},  {45.00870, -1.636257}};
    for (const auto& point : published) CHECK(distance(wheel, point) < 5e-6);
}

TEST_CASE("the curve of S1002 stays within a nanometre of its formula, but for where the throat is bent", "[profile]") {
    const ProfileCurve wheel(formula_points(S1002{}));
    REQUIRE(wheel.y_is_monotone());
    CHECK(wheel.points().size() < 1000);
    double farthest = 0, farthest_of_bends = 0;
    for (int k = 0; k <= 50000; ++k) {
        const double s = wheel.end() * k / 50000;
        const auto at = wheel.at(s);
        const bool bends = (at.y > -35.1 && at.y < -32) || (at.y > -29 && at.y < -25.9);
        double& most = bends ? farthest_of_bends : farthest;
        most = std::max(most, std::abs((at.z - s1002(at.y)) * std::cos(wheel.angle(s))));
    }
    CHECK(farthest < 1e-6);
    CHECK(farthest_of_bends < 1.2e-4);
    CHECK_THAT(wheel.at(0).y, WithinAbs(-70, 1e-12));
    CHECK_THAT(wheel.at(wheel.end()).y, WithinAbs(60, 1e-12));
    CHECK_THAT(wheel.at(wheel.s_at_y(0)).z, WithinAbs(0, 1e-9));
}

TEST_CASE("the curvature of S1002 is that of its pieces", "[profile]") {
    const ProfileCurve wheel(formula_points(S1002{}));
    for (const auto& [y, curvature] :
         {std::pair(-65., -1 / 20.5), {-55., -1 / 12.}, {-45., -1 / 20.}, {-39.1, 0.}, {-37., 1 / 13.}, {45., 0.}})
        CHECK_THAT(wheel.curvature(wheel.s_at_y(y)), WithinAbs(curvature, 1e-4));
    for (double y = -36; y < 32; y += 0.01) CHECK(std::abs(wheel.curvature(wheel.s_at_y(y))) < 0.08);
}

TEST_CASE("the head of 60E1 at 1/40 meets its published points", "[profile]") {
    const ProfileCurve rail(formula_points(Rail60E1{1.0 / 40}));
    const std::vector<ProfilePoint> published{{-41.99331, 10.261239}, {-38.01495, 5.238935}, {-34.94489, 3.498531},
                                              {-29.94111, 2.170048},  {-24.85129, 1.250889}, {-18.02543, 0.542383},
                                              {-10.01919, 0.167553},  {-3.18239, 0.016943},  {3.05129, 0.015465},
                                              {9.90403, 0.382006},    {18.09360, 1.603961},  {25.01531, 5.163871},
                                              {28.01832, 9.742797}};
    for (const auto& point : published) CHECK(distance(rail, point) < 5e-5);
}

TEST_CASE("the upright head of 60E1 is made of its arcs", "[profile]") {
    const ProfileCurve rail(formula_points(Rail60E1{}));
    for (const double y : {0.0, 3.0, -9.0, 10.2}) {
        const double s = rail.s_at_y(y);
        CHECK_THAT(rail.at(s).z, WithinAbs(300 - std::sqrt(300 * 300 - y * y), 1e-6));
        CHECK_THAT(rail.curvature(s), WithinAbs(1.0 / 300, 1e-6));
    }
    CHECK_THAT(rail.curvature(rail.s_at_y(18)), WithinAbs(1.0 / 80, 1e-6));
    CHECK_THAT(rail.curvature(rail.s_at_y(-31)), WithinAbs(1.0 / 13, 1e-4));
    CHECK_THAT(rail.at(rail.s_at_y(36)).z, WithinAbs(14.26, 1e-3));
    CHECK_THAT(std::tan(rail.angle(rail.end())), WithinAbs(20, 1e-3));
}

TEST_CASE("an inclined head is the upright one rotated, its top at zero", "[profile]") {
    const double inclination = GENERATE(1.0 / 40, 1.0 / 20, -1.0 / 20, 0.15);
    const auto upright = formula_points(Rail60E1{}), inclined = formula_points(Rail60E1{inclination});
    REQUIRE(inclined.size() == upright.size());
    const auto [first, last] = std::pair(std::size_t(0), upright.size() - 1);
    CHECK_THAT(std::hypot(inclined[last].y - inclined[first].y, inclined[last].z - inclined[first].z),
               WithinAbs(std::hypot(upright[last].y - upright[first].y, upright[last].z - upright[first].z), 1e-10));
    CHECK_THAT((inclined[last].z - inclined[first].z) / (inclined[last].y - inclined[first].y),
               WithinAbs(-inclination, 1e-12));  // the gauge side, y < 0, is lower
    double top = 1;
    const ProfileCurve curve(inclined);
    for (int k = 0; k <= 20000; ++k) top = std::min(top, curve.at(curve.end() * k / 20000).z);
    CHECK_THAT(top, WithinAbs(0, 1e-6));
}

TEST_CASE("arcs and cones are what their parameters say", "[profile]") {
    const double radius = GENERATE(300., -500.), slope = GENERATE(0., -0.05);
    const ProfileCurve arc(formula_points(ArcProfile{radius, slope, -30, 20}));
    const double origin = arc.s_at_y(0);
    CHECK_THAT(arc.at(origin).z, WithinAbs(0, 1e-8));
    CHECK_THAT(std::tan(arc.angle(origin)), WithinAbs(slope, 1e-8));
    for (const double y : {-29.0, -5.0, 19.0}) CHECK_THAT(arc.curvature(arc.s_at_y(y)), WithinAbs(1 / radius, 1e-6));
    CHECK_THAT(arc.at(0).y, WithinAbs(-30, 1e-10));
    CHECK_THAT(arc.at(arc.end()).y, WithinAbs(20, 1e-10));
    const ProfileCurve cone(formula_points(ConeProfile{-0.05, -50, 60}));
    CHECK_THAT(cone.at(cone.s_at_y(-31)).z, WithinAbs(1.55, 1e-12));
}

TEST_CASE("parameters that make no profile are refused", "[profile]") {
    const auto refused = [](const ProfileShape& shape, const std::string& what) {
        CHECK_THROWS_MATCHES(validate({ProfileKind::rail, shape}), InvalidArgument,
                             MessageMatches(ContainsSubstring(what)));
    };
    refused(Rail60E1{40}, "profile.rail_60e1.inclination is 40; it must be a slope");
    refused(Rail60E1{std::nan("")}, "inclination is nan");
    refused(ArcProfile{0}, "profile.arc.radius is 0");
    refused(ArcProfile{20}, "profile.arc has the radius 20 and does not reach its end at y = -40");
    refused(ArcProfile{300, 10}, "profile.arc.slope is 10");
    refused(ConeProfile{0.05, 3, 3}, "profile.cone.to is 3");
    refused(ConeProfile{0.05, -1e9, 3}, "profile.cone.from is -1e+09");
    refused(ProfilePoints{{}, 0}, "profile.unit is 0");
    refused(ProfilePoints{{}, 1, false, false, -1}, "profile.smoothing_length is -1");
    refused(ProfilePoints{std::vector<ProfilePoint>(20001)},
            "profile.points has 20001 entries, but at most 20000 are allowed");
    CHECK_NOTHROW(validate({ProfileKind::wheel, S1002{}}));
}

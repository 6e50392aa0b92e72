// Tests the side of a rail on which wheels run.
#include "geometry/profile/gauge_side.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double stretch = 1.1;  // makes all numbers inexact

/// Creates a head of two parabolas that meet at its top, z = stretch y^2/left for y < 0, and y^2/right on the other
/// side.
ProfileCurve head(double top, double left, double right) {
    std::vector<ProfilePoint> points;
    for (int i = -300; i <= 300; ++i) {
        const double y = 0.1 * i;
        points.push_back({y, stretch * (top + y * y / (i < 0 ? left : right))});
    }
    return ProfileCurve(points);
}

}  // namespace

TEST_CASE("Heights of a rail, and their rounding, do not change its gauge side", "[profile]") {
    // Sides are compared 0.2 mm below the top, and at the end of the flatter one.
    const double between = std::sqrt(0.2 / stretch) - std::sqrt(30.0 * 30 / 400);
    const double beside = 0.5 * (std::sqrt(400) - std::sqrt(200)) * between;
    for (int k = 0; k < 300; ++k) {
        const double top = 0.1 * k - 13.7;
        CAPTURE(top);
        CHECK_THAT(geometry::top_beside_middle(head(top, 200, 200)).value(), WithinAbs(0, 1e-9));
        CHECK_THAT(geometry::top_beside_middle(head(top, 200, 400)).value(), WithinAbs(beside, 0.01));
        CHECK_THAT(geometry::top_beside_middle(head(top, 400, 200)).value(), WithinAbs(-beside, 0.01));
        CHECK_FALSE(geometry::has_gauge_side_at_right(head(top, 200, 200)));
        CHECK(geometry::has_gauge_side_at_right(head(top, 200, 400)));
        CHECK_FALSE(geometry::has_gauge_side_at_right(head(top, 400, 200)));
    }
}

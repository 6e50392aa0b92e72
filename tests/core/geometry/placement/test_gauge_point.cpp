// Tests that the curve determines the position of a rail, not the straight lines between its points.
#include "geometry/placement/gauge_point.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

#include "contactd/make_profile.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "geometry/placement/rail_surface.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Returns points of a curve at equal distances in mm.
std::vector<ProfilePoint> points_of(const ProfileCurve& curve, double spacing) {
    const int pieces = static_cast<int>(std::ceil(curve.end() / spacing));
    std::vector<ProfilePoint> points;
    for (int i = 0; i <= pieces; ++i) points.push_back(curve.at(curve.end() * i / pieces));
    return points;
}

ProfileCurve head() {
    return make_profile({ProfileKind::rail, Rail60E1{1.0 / 40}}).curve;
}

/// By looking everywhere.
ProfilePoint origin_by_looking(const ProfileCurve& curve, const Track& track) {
    constexpr int looks = 1000000;
    std::vector<ProfilePoint> points;
    for (int i = 0; i <= looks; ++i) points.push_back(geometry::canted(curve.at(curve.end() * i / looks), track.cant));
    auto at = std::min_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.z < b.z; });
    const double top = at->z;
    double gauge_y = at->y;
    const double lowest = top + track.gauge_height;
    for (; at != points.begin() && (at - 1)->z <= lowest; --at) gauge_y = std::min(gauge_y, (at - 1)->y);
    if (at != points.begin()) {
        const ProfilePoint& below = *(at - 1);
        gauge_y = std::min(gauge_y, std::lerp(at->y, below.y, (lowest - at->z) / (below.z - at->z)));
    }
    return {track.gauge / 2 - gauge_y, -top};
}

}  // namespace

TEST_CASE("Top and gauge point of a rail by points lie on its spline") {
    const double spacing = GENERATE(0.7, 1.3, 4.0, 8.8);
    Track track;
    track.cant = GENERATE(0.0, 0.025, -0.05);
    track.gauge_height = GENERATE(14.0, 3.0);
    const ProfileCurve curve(points_of(head(), spacing));
    const ProfilePoint found = geometry::rail_origin(curve, track), expected = origin_by_looking(curve, track);
    CHECK_THAT(found.y, WithinAbs(expected.y, 2e-5));
    CHECK_THAT(found.z, WithinAbs(expected.z, 1e-9));
}

TEST_CASE("A rail does not move when more points of the same surface are given") {
    const double spacing = GENERATE(0.7, 1.3, 8.8);
    const ProfileCurve coarse(points_of(head(), spacing));
    const ProfilePoint few = geometry::rail_origin(coarse, {});
    const ProfilePoint many = geometry::rail_origin(ProfileCurve(points_of(coarse, 0.02)), {});
    CHECK_THAT(few.y, WithinAbs(many.y, 1e-6));
    CHECK_THAT(few.z, WithinAbs(many.z, 1e-7));
}

TEST_CASE("The top of an arc lies between its points") {
    std::vector<ProfilePoint> points;
    for (double y = -27.5; y < 30; y += 5) points.push_back({y, 80 - std::sqrt(6400 - y * y)});
    const ProfilePoint origin = geometry::rail_origin(ProfileCurve(points), Track{.gauge = 1435, .gauge_height = 2});
    CHECK_THAT(origin.z, WithinAbs(0, 1e-3));  // the highest points lie 0.04 mm below
    CHECK_THAT(origin.y, WithinAbs(717.5 + std::sqrt(6400 - 78 * 78), 1e-2));
}

TEST_CASE("A gauge that is measured at the top is that of the top, and one below all points that of the end") {
    const ProfileCurve curve = make_profile({ProfileKind::rail, ArcProfile{300, 0, -30, 30}}).curve;
    CHECK_THAT(geometry::rail_origin(curve, Track{.gauge_height = 0}).y, WithinAbs(717.5, 1e-6));
    const Track deep{.gauge_height = 2};  // the ends lie 1.5 mm below
    CHECK_THAT(geometry::rail_origin(curve, deep).y, WithinAbs(747.5, 1e-9));
}

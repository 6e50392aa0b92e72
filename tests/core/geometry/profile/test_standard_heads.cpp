// Heads of rails by name: their drawings' dimensions, joints, and points of a second source.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/profile.hpp"
#include "geometry/profile/formula_points.hpp"
#include "second_sources.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using geometry::formula_points;

namespace {

/// How far a curve passes from a point (mm).
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

/// A head by its drawing: the width and the depth where its side begins, and its arcs.
struct Drawing {
    StandardName name;
    double width, depth, steepness;
    std::vector<double> radii, widths;
};

const std::vector<Drawing> drawings{
    {StandardName::n49E5, 67, 14.28, 17.2, {115, 16.5, 15.5, 7.64}, {41.342, 62.980, 66}},
    {StandardName::n54E1, 70, 14.1, 20, {300, 80, 13}, {20.024, 49.727}},
    {StandardName::n54E3, 67, 14, 17.2, {300, 80, 13}, {15.267, 46.835}},
    {StandardName::n60E1, 72, 14.3, 20, {300, 80, 13}, {20.456, 52.053}},
    {StandardName::n60E2, 72, 14.3, 20, {200, 70, 16, 8}, {23.778, 48.913, 70.774}}};

}  // namespace

TEST_CASE("Heads of rails by name meet the points of a second source", "[profile]") {
    const auto& source = GENERATE(from_range(test::second_sources));
    CAPTURE(static_cast<int>(source.name));
    const ProfileCurve curve(formula_points(StandardProfile{source.name}));
    double farthest = 0;
    for (const ProfilePoint& point : source.points) farthest = std::max(farthest, distance(curve, point));
    CHECK(farthest < source.within);
}

TEST_CASE("Arcs of a head have the radii and widths of the drawing, and join with the same tangent", "[profile]") {
    const auto& drawing = GENERATE(from_range(drawings));
    CAPTURE(static_cast<int>(drawing.name));
    const ProfileCurve curve(formula_points(StandardProfile{drawing.name}));
    CHECK_THAT(curve.at(curve.s_at_y(0)).z, WithinAbs(0, 1e-9));
    // The widths of the heads in catalogues, 67, 70 and 72 mm, are those where the side begins.
    CHECK_THAT(curve.at(curve.s_at_y(drawing.width / 2)).z, WithinAbs(drawing.depth, 4e-3));
    CHECK_THAT(std::tan(curve.angle(curve.end())), WithinAbs(drawing.steepness, 1e-3));
    for (std::size_t i = 0; i < drawing.widths.size(); ++i) {
        const double joint = curve.s_at_y(drawing.widths[i] / 2);
        CHECK_THAT(curve.curvature(joint - 0.5), WithinAbs(1 / drawing.radii[i], 2e-4));
        CHECK_THAT(curve.curvature(joint + 0.5), WithinAbs(1 / drawing.radii[i + 1], 2e-4));
        CHECK_THAT(curve.angle(joint + 0.01) - curve.angle(joint - 0.01), WithinAbs(0, 0.02 / 7));
    }
}

TEST_CASE("Names of existing shapes have the same points to the last bit", "[profile]") {
    CHECK(formula_points(StandardProfile{StandardName::S1002}) == formula_points(S1002{}));
    CHECK(formula_points(StandardProfile{StandardName::UIC60, 0.025}) == formula_points(Rail60E1{0.025}));
}

TEST_CASE("60E1 deviates from UIC60 by 0.04 mm", "[profile]") {
    const ProfileCurve uic60(formula_points(Rail60E1{}));
    double farthest = 0;
    for (const ProfilePoint& point : formula_points(StandardProfile{StandardName::n60E1}))
        if (point.z < 14) farthest = std::max(farthest, distance(uic60, point));
    CHECK_THAT(farthest, WithinAbs(0.0392, 1e-4));
}

TEST_CASE("A head by name is rotated as a whole, its top at zero", "[profile]") {
    const auto& drawing = GENERATE(from_range(drawings));
    const double inclination = GENERATE(1.0 / 40, -1.0 / 20, 0.15);
    const auto upright = formula_points(StandardProfile{drawing.name}),
               inclined = formula_points(StandardProfile{drawing.name, inclination});
    REQUIRE(inclined.size() == upright.size());
    const std::size_t last = upright.size() - 1;
    CHECK_THAT(std::hypot(inclined[last].y - inclined[0].y, inclined[last].z - inclined[0].z),
               WithinAbs(std::hypot(upright[last].y - upright[0].y, upright[last].z - upright[0].z), 1e-10));
    CHECK_THAT((inclined[last].z - inclined[0].z) / (inclined[last].y - inclined[0].y), WithinAbs(-inclination, 1e-12));
    const ProfileCurve curve(inclined);
    double top = 1;
    for (int k = 0; k <= 20000; ++k) top = std::min(top, curve.at(curve.end() * k / 20000).z);
    CHECK_THAT(top, WithinAbs(0, 1e-5));
}

TEST_CASE("A name of the other kind is refused, and so is a wheel that leans", "[profile]") {
    const auto refused = [](ProfileKind kind, const StandardProfile& profile, const std::string& what) {
        CHECK_THROWS_MATCHES(make_profile({kind, profile}), InvalidArgument, MessageMatches(ContainsSubstring(what)));
    };
    refused(ProfileKind::rail, {StandardName::S1002}, "profile.standard.name is S1002, which is a wheel; give the");
    refused(ProfileKind::wheel, {StandardName::n54E1}, "profile.standard.name is 54E1, which is a rail; give the");
    refused(ProfileKind::wheel, {StandardName::S1002, 0.025}, "profile.standard.inclination is 0.025, but S1002 is a");
    refused(ProfileKind::rail, {StandardName::n54E1, 40}, "profile.standard.inclination is 40; it must be a slope");
    CHECK_NOTHROW(make_profile({ProfileKind::rail, StandardProfile{StandardName::n60E2, 0.05}}));
}

// Compares the transposed spline with differences of its points.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/make_profile.hpp"
#include "geometry/placement/rail_origin_gradient.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/profile/curve_cotangent.hpp"
#include "geometry/profile/given_points_gradient.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

using Points = std::vector<ProfilePoint>;

Points uneven_points() {
    Points points;
    for (int i = 0; i < 12; ++i) points.push_back({3.0 * i + std::sin(5.0 * i), 4 * std::cos(0.3 * i) + 0.1 * (i % 3)});
    return points;
}

/// Compares a gradient by points with central differences of a function of the points.
template <class Function>
void check_by_points(const Points& points, const Points& gradient, const Function& function, double step = 1e-5) {
    double largest = 0;
    for (const ProfilePoint& by : gradient) largest = std::max({largest, std::abs(by.y), std::abs(by.z)});
    for (std::size_t i = 0; i < points.size(); ++i)
        for (double ProfilePoint::* of : {&ProfilePoint::y, &ProfilePoint::z}) {
            Points more = points, less = points;
            more[i].*of += step;
            less[i].*of -= step;
            INFO("point " << i << (of == &ProfilePoint::y ? " y" : " z"));
            CHECK_THAT(gradient[i].*of, WithinAbs((function(more) - function(less)) / (2 * step), 5e-6 * largest));
        }
}

}  // namespace

TEST_CASE("The gradient of places and slopes of a curve by its points agrees with differences") {
    const std::vector<std::size_t> kinks = GENERATE(std::vector<std::size_t>{}, std::vector<std::size_t>{4, 7});
    const Points points = uneven_points();
    const ProfileCurve curve(points, kinks);
    const std::vector<double> places{0.3, 5.1, 12.7, 12.9, 20.2, curve.end() - 0.4};
    const auto value = [&](const Points& of) {
        const ProfileCurve changed(of, kinks);
        double sum = 0, factor = 1;
        for (const double s : places) {
            const auto here = changed.place(s);
            sum += factor * here.at.y - 2 * here.at.z + 3 * here.slope.y + factor * here.slope.z;
            factor += 0.7;
        }
        return sum;
    };
    geometry::CurveCotangent cotangent(curve);
    double factor = 1;
    for (const double s : places) {
        cotangent.add(s, {factor, -2}, {3, factor});
        factor += 0.7;
    }
    check_by_points(points, cotangent.by_points(), value);
}

TEST_CASE("The gradient of the rail's origin by its points agrees with differences") {
    Track track;
    track.cant = GENERATE(0.0, 0.025);
    const ProfileCurve curve = make_profile({ProfileKind::rail, Rail60E1{}}).curve;
    Points thin;  // fewer points, for fewer differences
    for (std::size_t i = 0; i < curve.points().size(); i += 6) thin.push_back(curve.points()[i]);
    geometry::CurveCotangent cotangent{ProfileCurve(thin)};
    geometry::add_by_rail_origin(track, {1.3, -0.6}, cotangent);
    check_by_points(thin, cotangent.by_points(), [&](const Points& of) {
        const ProfilePoint origin = geometry::rail_origin(ProfileCurve(of), track);
        return 1.3 * origin.y - 0.6 * origin.z;
    });
}

TEST_CASE("The gradient of a curve by given points passes smoothing, cleaning, units and mirrors") {
    ProfilePoints given;
    given.smoothing_length = GENERATE(0.0, 4.0);
    const bool reversed = GENERATE(false, true);
    for (int i = 0; i <= 60; ++i) {
        const double y = -35 + 70.0 / 60 * i, head = y * y / 600;
        given.points.push_back({y + 0.1 * std::sin(7.0 * i), head + 0.02 * std::cos(11.0 * i)});
    }
    given.points.insert(given.points.begin() + 30, given.points[30]);  // repeated
    const ProfilePoint a = given.points[40], b = given.points[41];
    given.points.insert(given.points.begin() + 41, {a.y + 0.7 * (b.y - a.y), a.z + 0.003});  // a zigzag
    given.points.insert(given.points.begin() + 42, {a.y + 0.4 * (b.y - a.y), a.z + 0.002});
    if (reversed) {
        std::reverse(given.points.begin(), given.points.end());
        given.unit = 1000;
        given.mirror_y = given.mirror_z = true;
        for (ProfilePoint& point : given.points) point = {-point.y / 1000, -point.z / 1000};
    }
    const auto curve_of = [&](const Points& points) {
        ProfilePoints changed = given;
        changed.points = points;
        return make_profile({ProfileKind::rail, changed}).curve;
    };
    const std::vector<double> places{10.3, 31.2, 44.5, 46.9, 47.3};
    const auto value = [&](const Points& points) {
        const ProfileCurve curve = curve_of(points);
        double sum = 0, factor = 1;
        for (const double s : places) {
            const auto here = curve.place(s);
            sum += factor * here.at.y - 2 * here.at.z + 3 * here.slope.y + factor * here.slope.z;
            factor += 0.7;
        }
        return sum;
    };
    geometry::CurveCotangent cotangent(curve_of(given.points));
    double factor = 1;
    for (const double s : places) {
        cotangent.add(s, {factor, -2}, {3, factor});
        factor += 0.7;
    }
    REQUIRE(cotangent.curve().points().size() == 61 + 1);
    const Points gradient = geometry::by_given_points({ProfileKind::rail, given}, cotangent.by_points());
    check_by_points(given.points, gradient, value, 1e-5 / given.unit);
}

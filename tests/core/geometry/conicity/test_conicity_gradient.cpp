// Compares gradients of the harmonic conicity with differences.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/equivalent_conicity.hpp"
#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "geometry/conicity/conicity_gradient.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double bump(double y, double middle) {
    return std::exp(-(y - middle) * (y - middle) / 16);
}

ProfileCurve with_bump(const ProfileCurve& curve, double middle, double height) {
    std::vector<ProfilePoint> points = curve.points();
    for (ProfilePoint& point : points) point.z += height * bump(point.y, middle);
    return ProfileCurve(std::move(points), curve.kinks());
}

double along_bump(const std::vector<ProfilePoint>& gradient, const ProfileCurve& curve, double middle) {
    double sum = 0;
    for (std::size_t i = 0; i < gradient.size(); ++i) sum += gradient[i].z * bump(curve.points()[i].y, middle);
    return sum;
}

WheelsetOnTrack wheelset_of(const ProfileCurve& wheel, const ProfileCurve& rail) {
    return wheelset_on_track(wheel, rail);
}

}  // namespace

TEST_CASE("The gradient of the harmonic conicity agrees with differences, with leaps of the contact") {
    const ProfileCurve wheel = make_profile({ProfileKind::wheel, S1002{}}).curve,
                       rail = make_profile({ProfileKind::rail, Rail60E1{1.0 / 40}}).curve;
    const double amplitude = GENERATE(2.0, 4.0);
    const WheelsetOnTrack wheelset = wheelset_of(wheel, rail);
    const geometry::ConicityGradient found = geometry::harmonic_gradient(wheelset, amplitude);
    const ConicitySettings fine{.tolerance = 1e-5};
    CHECK_THAT(found.harmonic,
               WithinRel(equivalent_conicities(wheelset, std::array{amplitude}, fine)[0].harmonic, 1e-3));
    double largest = 0;
    std::vector<std::array<double, 3>> pairs;
    for (const bool of_wheel : {true, false})
        for (const double middle : {-20.0, -10.0, -3.0, 3.0, 9.0}) {
            const auto conicity = [&](double height) {
                WheelsetOnTrack changed = wheelset;  // the right side only
                if (of_wheel)
                    changed.right.wheel = with_bump(wheel, middle, height);
                else
                    changed.right.rail = with_bump(rail, middle, height);
                return geometry::harmonic_gradient(changed, amplitude).harmonic;
            };
            constexpr double step = 2e-4;
            const double difference = (conicity(step) - conicity(-step)) / (2 * step);
            const double gradient =
                of_wheel ? along_bump(found.right.wheel, wheel, middle) : along_bump(found.right.rail, rail, middle);
            pairs.push_back({of_wheel ? 1.0 : 0.0, gradient, difference});
            largest = std::max(largest, std::abs(difference));
        }
    for (const auto& [of_wheel, gradient, difference] : pairs) {
        CAPTURE(of_wheel, largest);
        CHECK_THAT(gradient, WithinAbs(difference, 5e-3 * largest));
    }
}

TEST_CASE("The gradient of the conicity of a cone by its slope is one") {
    const ProfileCurve wheel = make_profile({ProfileKind::wheel, ConeProfile{-0.05, -50, 50}}).curve,
                       rail = make_profile({ProfileKind::rail, ArcProfile{300, 0, -30, 30}}).curve;
    Track on_arc;
    on_arc.rail_origin = ProfilePoint{750, 0};
    const geometry::ConicityGradient found = geometry::harmonic_gradient(wheelset_on_track(wheel, rail, on_arc), 3);
    CHECK_THAT(found.harmonic, WithinRel(0.05, 1e-4));
    double by_slope = 0;  // of a wheel with another conicity, on both sides
    for (const auto* side : {&found.left, &found.right})
        for (std::size_t i = 0; i < wheel.points().size(); ++i) by_slope -= side->wheel[i].z * wheel.points()[i].y;
    CHECK_THAT(by_slope, WithinRel(1, 1e-3));
    for (const auto* side : {&found.left, &found.right}) {
        double lifted = 0;
        for (const ProfilePoint& by : side->rail) lifted += by.z;
        CHECK_THAT(lifted, WithinAbs(0, 1e-9));
    }
}

TEST_CASE("Points of a rail with cant move its origin, too") {
    const ProfileCurve wheel = make_profile({ProfileKind::wheel, S1002{}}).curve,
                       rail = make_profile({ProfileKind::rail, Rail60E1{}}).curve;
    Track track;
    track.cant = 0.025;
    constexpr double amplitude = 3, step = 2e-4, gauge_side = -36;
    const auto found = geometry::harmonic_gradient(wheelset_on_track(wheel, rail, track), amplitude);
    double gradient = 0;
    for (const auto* side : {&found.left, &found.right})
        gradient += along_bump(geometry::by_rail_points(*side, rail, track), rail, gauge_side);
    const auto conicity = [&](double height) {
        const ProfileCurve changed = with_bump(rail, gauge_side, height);
        return geometry::harmonic_gradient(wheelset_on_track(wheel, changed, track), amplitude).harmonic;
    };
    const double difference = (conicity(step) - conicity(-step)) / (2 * step);
    CHECK(std::abs(difference) > 1e-4);
    CHECK_THAT(gradient, WithinRel(difference, 1e-2));
}

TEST_CASE("The conicity has no gradient with the roll that both contacts require") {
    const ProfileCurve wheel = make_profile({ProfileKind::wheel, S1002{}}).curve,
                       rail = make_profile({ProfileKind::rail, Rail60E1{1.0 / 40}}).curve;
    CHECK_THROWS_AS(geometry::harmonic_gradient(wheelset_of(wheel, rail), 3, {.roll = WheelsetRoll::demanded}),
                    InvalidArgument);
}

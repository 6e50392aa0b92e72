// Tests radii of out-of-round wheels, between their slices.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "geometry/placement/out_of_round.hpp"

using namespace contactd;
using namespace contactd::geometry;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double pi = std::numbers::pi;

/// Creates a line over a wheel's width, with a deviation `radius` and an inclination `slope`.
ProfileCurve line(double radius, double slope = 0, double from = -40, double to = 40) {
    return ProfileCurve({{from, radius + slope * from}, {0, radius}, {to, radius + slope * to}});
}

/// Creates slices around the wheel at equal steps.
template <class Radius>
OutOfRound by_radius(int count, const Radius& radius) {
    std::vector<double> angles;
    std::vector<ProfileCurve> slices;
    for (int i = 0; i < count; ++i) {
        angles.push_back(-pi + 2 * pi * i / count);
        slices.push_back(line(radius(angles.back())));
    }
    return {angles, slices};
}

}  // namespace

TEST_CASE("Slices that are equal leave a wheel round") {
    const ProfileCurve wheel = make_profile({ProfileKind::wheel, S1002{}}).curve;
    const OutOfRound beside({-0.2, 0.1, 2}, {wheel, wheel, wheel});
    for (const double angle : {-7.0, -0.2, 0.0, 1.3, 3.0, 6.2})
        for (const double s : {0.0, 20.0, 60.0, wheel.end()}) {
            const auto [radius, by_angle, by_s] = beside.at(angle, s);
            CHECK_THAT(radius, WithinAbs(0, 1e-9));
            CHECK_THAT(by_angle, WithinAbs(0, 1e-9));
            CHECK_THAT(by_s, WithinAbs(0, 1e-8));
        }
    CHECK_THAT(beside.steepest(), WithinAbs(0, 1e-8));
}

TEST_CASE("Radii go through the slices, and round the wheel once more") {
    const auto wave = [](double angle) { return 0.3 * std::cos(angle) + 0.1 * std::sin(3 * angle); };
    const OutOfRound beside = by_radius(90, wave);
    const double first = wave(-pi);
    for (int i = 0; i < 90; ++i) {
        const double angle = -pi + 2 * pi * i / 90;
        CHECK_THAT(beside.at(angle, 30).radius, WithinAbs(wave(angle) - first, 1e-10));
        CHECK_THAT(beside.at(angle + 8 * pi, 30).radius, WithinAbs(wave(angle) - first, 1e-10));
    }
    for (double angle = -4; angle < 4; angle += 0.0173) {
        const auto [radius, by_angle, by_s] = beside.at(angle, 30);
        CHECK_THAT(radius, WithinAbs(wave(angle) - first, 5e-4));
        const double step = 1e-5;
        const double difference =
            (beside.at(angle + step, 30).radius - beside.at(angle - step, 30).radius) / (2 * step);
        CHECK_THAT(by_angle, WithinAbs(difference, 1e-6));
        CHECK(std::abs(by_angle) <= beside.steepest() + 1e-12);
    }
}

TEST_CASE("More slices come closer to a smooth wheel by the second power of their distance at least") {
    const auto wave = [](double angle) { return 0.2 * std::cos(2 * angle); };
    const auto error = [&](int count) {
        const OutOfRound beside = by_radius(count, wave);
        double largest = 0;
        for (double angle = -3; angle < 3; angle += 0.01)
            largest = std::max(largest, std::abs(beside.at(angle, 30).radius - wave(angle) + wave(-pi)));
        return largest;
    };
    CHECK(error(80) < error(40) / 3.5);
    CHECK(error(160) < error(80) / 3.5);
}

TEST_CASE("Beside the edge of a flat the wheel is as round as its slices") {
    const double R = 460, depth = 0.5, edge = std::acos((R - depth) / R);
    std::vector<double> angles;
    std::vector<ProfileCurve> slices;
    for (int i = -20; i <= 20; ++i) {
        angles.push_back(edge * i / 10);
        slices.push_back(line(std::min(0.0, (R - depth) / std::cos(angles.back()) - R)));
    }
    const OutOfRound beside(angles, slices);
    for (double angle = edge; angle < 2 * pi - edge; angle += 1e-3)
        CHECK_THAT(beside.at(angle, 40).radius, WithinAbs(0, 1e-12));
    for (double angle = -edge; angle < edge; angle += edge / 77)
        CHECK_THAT(beside.at(angle, 40).radius, WithinAbs((R - depth) / std::cos(angle) - R, 0.042 * depth));
}

TEST_CASE("A flat that few slices tell of leaves the rest of the wheel round") {
    std::vector<double> angles;
    std::vector<ProfileCurve> slices;
    for (int i = -2; i <= 2; ++i) {
        angles.push_back(0.03 * i);
        slices.push_back(line(0.2 * std::abs(i) - 0.4));
    }
    const OutOfRound beside(angles, slices);
    for (double angle = 0.06; angle < 2 * pi - 0.06; angle += 1e-3)
        CHECK_THAT(beside.at(angle, 40).radius, WithinAbs(0, 1e-12));
    CHECK_THAT(beside.at(0, 40).radius, WithinAbs(-0.4, 1e-12));
}

TEST_CASE("Radii stay between their slices, however far these are from each other") {
    const std::vector<double> angles{-1, -0.99, -0.5, 0, 2, 2.01, 3}, radii{0, 0.3, 0.3, 0.35, 0.4, 0.5, 0.7};
    std::vector<ProfileCurve> slices;
    for (const double radius : radii) slices.push_back(line(radius));
    const OutOfRound beside(angles, slices);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
        for (double share = 0; share <= 1; share += 0.01) {
            const double radius = beside.at(std::lerp(angles[i], angles[i + 1], share), 40).radius;
            CHECK(radius >= radii[i] - 1e-12);
            CHECK(radius <= radii[i + 1] + 1e-12);
        }
}

TEST_CASE("Along the profile a slice is compared at equal y") {
    const ProfileCurve first = line(0, -0.05), second = line(0.4, -0.02);
    const OutOfRound beside({0, pi}, {first, second});
    for (const double s : {3.3, 40.0, 71.0}) {
        const double y = first.at(s).y;
        const auto [radius, by_angle, by_s] = beside.at(pi, s);
        CHECK_THAT(radius, WithinAbs(0.4 + 0.03 * y, 1e-9));
        CHECK_THAT(by_angle, WithinAbs(0, 1e-9));
        CHECK_THAT(by_s, WithinAbs(0.03 * first.slope(s).y, 1e-8));
    }
}

TEST_CASE("Slices that make no wheel are refused by name") {
    const auto refused = [](const ProfileCurve& second, const std::string& sentence) {
        CHECK_THROWS_AS(OutOfRound({0, 1}, {line(0), second}), InvalidArgument);
        CHECK_THROWS_WITH(OutOfRound({0, 1}, {line(0), second}), ContainsSubstring(sentence));
    };
    refused(line(0, 0, -30, 40), "wheel_slices[1].profile reaches from y = -30 to 40 mm, but the first slice from -40");
    refused(line(460), "wheel_slices[1].profile differs by 460 mm from the first slice at y = -40 mm");
}

TEST_CASE("Points of slices that correspond lie at equal shares, half a millimetre apart at most") {
    const OutOfRound beside({-1, 0.5, 2}, {line(0, 0.01), line(0.3, 0.01), line(0.2, 0.01)});
    const double length = 80 * std::hypot(1, 0.01);
    REQUIRE(beside.nodes() == static_cast<std::size_t>(length / 0.5) + 2);
    const double share = 40.0 / static_cast<double>(beside.nodes() - 1);
    CHECK_THAT(beside.node(0.5, 40).y, WithinAbs(-40 + 80 * share, 1e-9));
    CHECK_THAT(beside.node(0.5, 40).z, WithinAbs(0.3 + 0.01 * (-40 + 80 * share), 1e-9));
    for (const double angle : {-1.0, 0.2, 1.9, 3.4}) {
        const auto [y, z] = beside.node(angle, 40);
        CHECK_THAT(z, WithinAbs(0.01 * y + beside.at(angle, 30).radius, 1e-9));
    }
}

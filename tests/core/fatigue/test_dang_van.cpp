// Tests Dang Van's stress of known histories, and the smallest ball around points.
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "fatigue/dang_van.hpp"
#include "fatigue/smallest_ball.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double distance(const DeviatorPoint& a, const DeviatorPoint& b) {
    double sum = 0;
    for (std::size_t c = 0; c < a.size(); ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return std::sqrt(sum);
}

}  // namespace

TEST_CASE("The smallest ball holds all points, and no other centre has a smaller one") {
    std::mt19937 generator(GENERATE(1, 2, 3, 4, 5, 6, 7, 8));
    std::normal_distribution<double> normal;
    const std::size_t dimensions = GENERATE(1, 2, 5);
    std::vector<DeviatorPoint> points(200);
    for (DeviatorPoint& point : points)
        for (std::size_t c = 0; c < dimensions; ++c) point[c] = normal(generator);
    const Ball ball = smallest_ball(points);
    const auto radius_around = [&](const DeviatorPoint& centre) {
        double largest = 0;
        for (const DeviatorPoint& point : points) largest = std::max(largest, distance(centre, point));
        return largest;
    };
    CHECK_THAT(radius_around(ball.centre), WithinRel(ball.radius, 1e-8));
    for (int trial = 0; trial < 200; ++trial) {
        DeviatorPoint moved = ball.centre;
        for (double& value : moved) value += 1e-3 * normal(generator);
        CHECK(radius_around(moved) > ball.radius);
    }
}

TEST_CASE("One point, equal points and points on a line have their smallest ball") {
    const DeviatorPoint a{1, 2, 3, 4, 5}, b{3, 2, 3, 4, 5}, between{1.5, 2, 3, 4, 5};
    CHECK(smallest_ball(std::vector{a}).radius == 0);
    CHECK(smallest_ball(std::vector{a, a, a}).radius == 0);
    const Ball ball = smallest_ball(std::vector{a, between, b, a, between});
    CHECK_THAT(ball.radius, WithinRel(1.0, 1e-12));
    CHECK_THAT(ball.centre[0], WithinRel(2.0, 1e-12));
}

TEST_CASE("The largest shear of a tensor is half the difference of its principal values") {
    CHECK_THAT(largest_shear({200, 0, 0, 0, 0, 0}), WithinRel(100.0, 1e-12));
    CHECK_THAT(largest_shear({-200, -200, 0, 0, 0, 0}), WithinRel(100.0, 1e-7));
    CHECK_THAT(largest_shear({50, 50, 50, 0, 70, 0}), WithinRel(70.0, 1e-12));
    CHECK_THAT(largest_shear({3, 1, 2, 0, 0, 0}), WithinRel(1.0, 1e-12));
    CHECK(largest_shear({5, 5, 5, 0, 0, 0}) == 0);
}

TEST_CASE("A history of pulsating tension has half the amplitude of its shear and all of its mean") {
    constexpr double a_DV = 0.3, sigma = 120;
    const std::vector<StressTensor> history{{sigma / 2, 0, 0, 0, 0, 0}, {sigma, 0, 0, 0, 0, 0}};
    CHECK_THAT(dang_van_stress(history, a_DV, 0), WithinRel(sigma / 4 + a_DV * sigma / 3, 1e-12));
    CHECK_THAT(dang_van_stress(history, a_DV, -90), WithinRel(sigma / 4 + a_DV * (sigma / 3 - 90), 1e-12));
}

TEST_CASE("Alternating shear counts by its amplitude") {
    const std::vector<StressTensor> history{{0, 0, 0, 0, 80, 0}, {0, 0, 0, 0, -80, 0}};
    CHECK_THAT(dang_van_stress(history, 0.3, 0), WithinRel(80.0, 1e-12));
}

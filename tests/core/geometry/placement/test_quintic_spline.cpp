// Tests splines from slice to slice: they keep the shape of the values, and are smooth.
#include "geometry/placement/quintic_spline.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

using namespace contactd::geometry;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double pi = std::numbers::pi;

struct Curve {
    QuinticSpline spline;
    std::vector<double> values;
    std::vector<KnotDerivatives> at = spline.derivatives(values);

    double piece(std::size_t i, double share, const std::function<QuinticWeights(double, double)>& weights) const {
        const std::size_t next = (i + 1) % values.size();
        return weights(share, spline.width(i)).sum(values[next] - values[i], at[i], at[next]);
    }
    double value(std::size_t i, double share) const { return values[i] + piece(i, share, QuinticWeights::of_value); }
    double slope(std::size_t i, double share) const { return piece(i, share, QuinticWeights::of_slope); }
    double curving(std::size_t i, double share) const {
        constexpr double step = 1e-5;
        return (slope(i, share + step) - slope(i, share - step)) / (2 * step * spline.width(i));
    }
};

Curve through(std::vector<double> knots, std::vector<double> values, double period = 0) {
    return {QuinticSpline(std::move(knots), period), std::move(values)};
}

std::vector<double> ascending(std::mt19937& random, std::size_t count) {
    std::lognormal_distribution<> width(0, 1.5);
    std::vector<double> knots{0};
    while (knots.size() < count) knots.push_back(knots.back() + width(random));
    return knots;
}

}  // namespace

TEST_CASE("Values that ascend are joined by a curve that does, and equal ones by a straight line") {
    std::mt19937 random(5);
    std::uniform_real_distribution<> share(0, 1);
    for (int round = 0; round < 300; ++round) {
        const auto knots = ascending(random, 2 + static_cast<std::size_t>(round % 9));
        std::vector<double> values{0};
        while (values.size() < knots.size())
            values.push_back(values.back() + (share(random) < 0.3 ? 0 : std::pow(10, 4 * share(random) - 4)));
        const double sign = round % 2 == 0 ? 1 : -1;
        for (double& value : values) value *= sign;
        const Curve curve = through(knots, values);
        for (std::size_t i = 0; i + 1 < knots.size(); ++i)
            for (double t = 0; t <= 1; t += 0.02) {
                INFO(round << ", piece " << i << " at " << t);
                if (values[i] == values[i + 1])
                    REQUIRE(curve.value(i, t) == values[i]);
                else
                    REQUIRE(sign * curve.slope(i, t) >= -1e-12);
            }
    }
}

TEST_CASE("Curvature is continuous, whatever the values") {
    std::mt19937 random(6);
    std::normal_distribution<> value;
    for (int round = 0; round < 100; ++round) {
        const auto knots = ascending(random, 7);
        std::vector<double> values;
        while (values.size() < knots.size()) values.push_back(value(random));
        const Curve curve = through(knots, values, knots.back() + 1);
        for (std::size_t i = 0; i < knots.size(); ++i) {
            const std::size_t before = (i + 6) % 7;
            CHECK_THAT(curve.value(before, 1), WithinAbs(values[i], 1e-12));
            CHECK_THAT(curve.slope(before, 1), WithinAbs(curve.slope(i, 0), 1e-9));
            const double scale = 1 + std::abs(curve.curving(i, 0));
            CHECK_THAT(curve.curving(before, 1) / scale, WithinAbs(curve.curving(i, 0) / scale, 1e-3));
        }
    }
}

TEST_CASE("A step between equal values is passed once, and leaves no waves") {
    const Curve curve = through({0, 1, 2, 3, 4, 5}, {2, 2, 2, 1.9, 1.9, 1.9});
    for (const std::size_t i : {0u, 1u, 3u, 4u})
        for (double t = 0; t <= 1; t += 0.1) CHECK(curve.value(i, t) == curve.values[i]);
    for (double t = 0; t <= 1; t += 0.1) CHECK(std::abs(curve.value(2, t) - 1.95) <= 0.05 + 1e-12);
}

TEST_CASE("Curvatures of smooth values err by the third power of their distance") {
    const double begin = GENERATE(0.0, 0.013, 0.031);  // also an extremum between two values
    const auto error = [&](int count) {
        std::vector<double> knots, values;
        for (int i = 0; i < count; ++i) {
            knots.push_back(begin + 2 * pi * i / count);
            values.push_back(std::cos(knots.back()) + 0.3 * std::sin(2 * knots.back()));
        }
        const Curve curve = through(knots, values, 2 * pi);
        double largest = 0;
        for (std::size_t i = 0; i < knots.size(); ++i)
            for (double t = 0.01; t < 1; t += 0.07) {
                const double x = knots[i] + t * 2 * pi / count;
                largest = std::max(largest, std::abs(curve.curving(i, t) + std::cos(x) + 1.2 * std::sin(2 * x)));
            }
        return largest;
    };
    CHECK(error(30) < 0.02);
    CHECK(error(60) < error(30) / 7);
}

TEST_CASE("Two values are joined by a line, and a line by itself") {
    CHECK_THAT(through({0, 4}, {1, 3}).value(0, 0.3), WithinAbs(1.6, 1e-12));
    const Curve line = through({0, 1, 5, 5.5, 7}, {0, 2, 10, 11, 14});
    for (const std::size_t i : {0u, 1u, 2u, 3u}) CHECK_THAT(line.slope(i, 0.4), WithinAbs(2, 1e-12));
}

TEST_CASE("Mirrored values have a mirrored curve") {
    const std::vector<double> knots{0, 1, 1.5, 3, 3.2, 5}, values{0, 0.2, -0.1, -0.4, 1, 1.1};
    std::vector<double> back, negative;
    for (std::size_t i = knots.size(); i-- > 0;) {
        back.push_back(5 - knots[i]);
        negative.push_back(-values[i]);
    }
    const Curve curve = through(knots, values), mirrored = through(back, negative);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        CHECK_THAT(mirrored.value(4 - i, 0.7), WithinAbs(-curve.value(i, 0.3), 1e-12));
}

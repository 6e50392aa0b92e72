// Smoothing splines: what they keep of waves, lines and noise.
#include "geometry/profile/smoothing.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace contactd::geometry;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double pi = std::numbers::pi, step = 0.1;

struct Samples {
    std::vector<double> knots, values, weights;
};

Samples samples_of(double (*function)(double)) {
    Samples samples;
    for (int i = 0; i <= 1000; ++i) {
        samples.knots.push_back(step * i);
        samples.values.push_back(function(step * i));
        samples.weights.push_back(step);
    }
    return samples;
}

}  // namespace

TEST_CASE("of a wave with the smoothing length half the amplitude is kept", "[profile]") {
    const auto wave = samples_of([](double s) { return std::sin(2 * pi * s / 5); });
    const auto halved = smoothed(wave.knots, wave.values, wave.weights, lambda_of(5));
    const auto kept = smoothed(wave.knots, wave.values, wave.weights, lambda_of(1));
    for (int i = 400; i < 600; ++i) {
        CHECK_THAT(halved[i], WithinAbs(0.5 * wave.values[i], 1e-3));
        CHECK_THAT(kept[i], WithinAbs(wave.values[i] / (1 + std::pow(5.0, -4)), 1e-5));
    }
}

TEST_CASE("a straight line is kept whatever is smoothed away", "[profile]") {
    const auto line = samples_of([](double s) { return 3 - 0.2 * s; });
    const auto smooth = smoothed(line.knots, line.values, line.weights, lambda_of(GENERATE(0.1, 5., 1000.)));
    for (int i = 0; i <= 1000; ++i) CHECK_THAT(smooth[i], WithinAbs(line.values[i], 1e-9));
}

TEST_CASE("the smoothed values make the functional least", "[profile]") {
    // Against a change of any value: the first variation is that of a quadratic form, so both signs must cost more.
    const std::vector<double> knots{0, 1, 2.5, 3, 4.2, 5}, values{0, 1, 0.5, 2, 1.5, 3}, weights{1, 2, 0.5, 1, 3, 1};
    const double lambda = 0.3;
    const auto smooth = smoothed(knots, values, weights, lambda);
    double force = 0, moment = 0;  // residuals of the weights are in balance, as a line may be added for nothing
    for (std::size_t i = 0; i < knots.size(); ++i) {
        force += weights[i] * (values[i] - smooth[i]);
        moment += weights[i] * (values[i] - smooth[i]) * knots[i];
    }
    CHECK_THAT(force, WithinAbs(0, 1e-13));
    CHECK_THAT(moment, WithinAbs(0, 1e-12));
    CHECK(std::abs(values[3] - smooth[3]) > 0.01);
    CHECK(smoothed(knots, values, weights, 0) == values);
}

// Tests the effect of smoothing splines on waves, lines and noise.
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
    // Changes any value in both directions: both must increase the sum, because the first variation of a quadratic form
    // vanishes.
    const std::vector<double> knots{0, 1, 2.5, 3, 4.2, 5}, values{0, 1, 0.5, 2, 1.5, 3}, weights{1, 2, 0.5, 1, 3, 1};
    const double lambda = 0.3;
    const auto smooth = smoothed(knots, values, weights, lambda);
    double force = 0, moment = 0;  // weighted residuals are in equilibrium, because adding a line has no cost
    for (std::size_t i = 0; i < knots.size(); ++i) {
        force += weights[i] * (values[i] - smooth[i]);
        moment += weights[i] * (values[i] - smooth[i]) * knots[i];
    }
    CHECK_THAT(force, WithinAbs(0, 1e-13));
    CHECK_THAT(moment, WithinAbs(0, 1e-12));
    CHECK(std::abs(values[3] - smooth[3]) > 0.01);
    CHECK(smoothed(knots, values, weights, 0) == values);
}

TEST_CASE("points that weigh alike keep half the amplitude of a wave by lambda and their distance", "[profile]") {
    const double length = GENERATE(2., 5., 20.);
    auto wave = samples_of([](double) { return 0.; });
    for (int i = 0; i <= 1000; ++i) wave.values[i] = std::sin(2 * pi * wave.knots[i] / length);
    const std::vector<double> alike(1001, 1.0);
    const double lambda = lambda_of(length) / step;
    CHECK_THAT(wavelength_of(lambda * step), WithinAbs(length, 1e-12));
    const auto halved = smoothed(wave.knots, wave.values, alike, lambda);
    for (int i = 400; i < 600; ++i) CHECK_THAT(halved[i], WithinAbs(0.5 * wave.values[i], 2e-3));
}

TEST_CASE("the third order keeps of waves what the spectrum of its splines says", "[profile]") {
    // For densely sampled exp(i w s), splines of the step h retain the share b^2 / (sum of b^2 + (L / 2 pi h)^6 (2
    // sin)^6), b = sinc(t/2)^4 at t = w h and, in the sum, at all t + 2 pi n; half would remain if they could represent
    // that wave.
    const double wavelength = 5, waves = GENERATE(4., 5., 10., 20.);
    const double h = wavelength / 4, t = 2 * pi / waves * h;
    const auto b = [](double angle) { return std::pow(std::sin(angle / 2) / (angle / 2), 4); };
    double squares = 0;
    for (int n = -20; n <= 20; ++n) squares += std::pow(b(t + 2 * pi * n), 2);
    const double penalty = std::pow(wavelength / (2 * pi * h) * 2 * std::sin(t / 2), 6);
    const double kept = b(t) * b(t) / (squares + penalty);
    if (waves == wavelength) CHECK_THAT(kept, WithinAbs(0.448, 1e-3));
    if (waves == 2 * wavelength) CHECK_THAT(kept, WithinAbs(0.984, 2e-3));
    auto wave = samples_of([](double) { return 0.; });
    for (int i = 0; i <= 1000; ++i) wave.values[i] = std::sin(2 * pi * wave.knots[i] / waves);
    const auto smooth = smoothed_by_third(wave.knots, wave.values, wave.weights, wavelength);
    // Returns the share of the wave itself. Splines also contain shorter waves, which vanish in these samples.
    double share = 0, all = 0;
    for (int i = 300; i < 700; ++i) {
        share += smooth[i] * wave.values[i];
        all += wave.values[i] * wave.values[i];
    }
    CHECK_THAT(share / all, WithinAbs(kept, 2e-3));
}

TEST_CASE("the third order keeps parabolas, and with them arcs better than the second", "[profile]") {
    const auto parabola = samples_of([](double s) { return 3 - 0.2 * s + 0.01 * s * s; });
    const double wavelength = GENERATE(1., 10., 300.);
    const auto smooth = smoothed_by_third(parabola.knots, parabola.values, parabola.weights, wavelength);
    for (int i = 0; i <= 1000; ++i) CHECK_THAT(smooth[i], WithinAbs(parabola.values[i], 1e-7));
    const std::vector<double> few{0, 1, 2}, values{0, 5, 1}, weights{1, 1, 1};
    CHECK(smoothed_by_third(few, values, weights, 5) == values);
    CHECK(smoothed_by_third(parabola.knots, parabola.values, parabola.weights, 0) == parabola.values);
}

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "creep_table/spline_axis.hpp"
#include "creep_table/spline_fit.hpp"

using namespace contactd::creep_table;
using Catch::Matchers::WithinAbs;

namespace {

const SplineAxis axis{-1, 2, 12};

template <class Function>
std::vector<double> fitted(Function f, SplineEnd first, SplineEnd last, double slope = 0) {
    std::vector<double> values;
    for (int i = 0; i <= axis.cells; ++i) values.push_back(f(axis.node(i)));
    values = with_zero_ends(values, axis.cells + 1, 1);
    values.front() = slope * axis.step();
    return multiply_along(spline_fit(axis.cells, first, last), values, 1);
}

template <class Function, class Slope>
void check(const std::vector<double>& coefficients, Function f, Slope slope, double tolerance) {
    const double x = GENERATE(-1.0, -0.9, 0.0, 0.33, 1.2, 1.95, 2.0);
    const SplineWeights<double> weights(axis, x);
    double value = 0, derivative = 0;
    for (int i = 0; i < 4; ++i) {
        value += weights.value[i] * coefficients[weights.cell + i];
        derivative += weights.slope[i] * coefficients[weights.cell + i];
    }
    CHECK_THAT(value, WithinAbs(f(x), tolerance));
    CHECK_THAT(derivative, WithinAbs(slope(x), 10 * tolerance));
}

}  // namespace

TEST_CASE("a spline reproduces a cubic polynomial", "[creep_table]") {
    const auto f = [](double x) { return 1 + x * (2 - x * (3 - x)); };
    const auto slope = [](double x) { return 2 - 6 * x + 3 * x * x; };
    check(fitted(f, SplineEnd::not_a_knot, SplineEnd::not_a_knot), f, slope, 1e-13);
    check(fitted(f, SplineEnd::slope, SplineEnd::not_a_knot, slope(-1)), f, slope, 1e-13);
}

TEST_CASE("splines continue by the symmetries at their ends", "[creep_table]") {
    const double k = std::numbers::pi / 3;
    const auto sine = [k](double x) { return std::sin(k * (x + 1)); };
    const auto cosine = [k](double x) { return std::cos(k * (x + 1)); };
    const auto slope_of_sine = [&](double x) { return k * cosine(x); };
    const auto slope_of_cosine = [&](double x) { return -k * sine(x); };
    check(fitted(sine, SplineEnd::odd, SplineEnd::odd), sine, slope_of_sine, 2e-5);
    check(fitted(cosine, SplineEnd::even, SplineEnd::even), cosine, slope_of_cosine, 2e-5);
    check(fitted(sine, SplineEnd::antiperiodic, SplineEnd::antiperiodic), sine, slope_of_sine, 2e-5);
    check(fitted(cosine, SplineEnd::antiperiodic, SplineEnd::antiperiodic), cosine, slope_of_cosine, 2e-5);
}

#include "geometry/placement/spline_along.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace contactd;
using namespace contactd::geometry;
using Catch::Matchers::WithinAbs;

namespace {

std::vector<double> uneven_knots(int n) {
    std::vector<double> knots{0};
    for (int i = 1; i < n; ++i) knots.push_back(knots.back() + 1 + 0.4 * std::sin(3 * i));
    return knots;
}

double between(const SplineAlong& spline, const LineAlong& line, std::size_t i, double t) {
    const double h = spline.width(i);
    const std::size_t next = (i + 1) % line.values.size();
    return line.values[i] + QuinticWeights::of_value(t, h).sum(line.values[next] - line.values[i], line.derivatives[i],
                                                               line.derivatives[next]);
}

}  // namespace

TEST_CASE("Splines of every kind follow a straight line") {
    const std::vector<double> knots = uneven_knots(7);
    std::vector<double> values;
    for (const double t : knots) values.push_back(2 - 0.5 * t);
    const SplineAlong spline(knots, GENERATE(SliceSpline::shape_preserving, SliceSpline::cubic));
    const LineAlong line = spline.line(values);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        for (const double t : {0.0, 0.3, 0.9})
            CHECK_THAT(between(spline, line, i, t), WithinAbs(2 - 0.5 * (knots[i] + t * spline.width(i)), 1e-12));
}

TEST_CASE("A cubic spline is one polynomial of degree three from knot to knot, with continuous curvature") {
    const std::vector<double> knots = uneven_knots(9), values{0, 1, -1, 2, 0, 0, 0, 3, 1};
    const SplineAlong spline(knots, SliceSpline::cubic);
    const LineAlong line = spline.line(values);
    CHECK(line.values == values);
    CHECK_THAT(line.derivatives.front().curving, WithinAbs(0, 1e-12));
    CHECK_THAT(line.derivatives.back().curving, WithinAbs(0, 1e-12));
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        // The fourth difference of a cubic vanishes.
        double fourth = 0;
        for (const auto& [k, weight] : {std::pair(0, 1), {1, -4}, {2, 6}, {3, -4}, {4, 1}})
            fourth += weight * between(spline, line, i, 0.25 * k);
        CHECK_THAT(fourth, WithinAbs(0, 1e-11));
    }
}

TEST_CASE("Round a wheel a cubic spline comes again with all its derivatives") {
    constexpr double turn = 2 * std::numbers::pi;
    std::vector<double> knots, values;
    for (int i = 0; i < 24; ++i) {
        knots.push_back(turn * i / 24);
        values.push_back(std::sin(2 * knots.back()));
    }
    const SplineAlong spline(knots, SliceSpline::cubic, turn);
    const LineAlong line = spline.line(values);
    for (std::size_t i = 0; i < knots.size(); ++i) {
        CHECK_THAT(line.derivatives[i].slope, WithinAbs(2 * std::cos(2 * knots[i]), 2e-3));
        CHECK_THAT(between(spline, line, i, 0.5), WithinAbs(std::sin(2 * (knots[i] + turn / 48)), 3e-4));
    }
}

TEST_CASE("An approximating spline has a sixth of both neighbours in it") {
    const std::vector<double> knots{0, 2, 4, 6, 8, 10}, values{0, 0, 6, 0, 0, 0};
    const SplineAlong spline(knots, SliceSpline::approximating);
    const LineAlong line = spline.line(values);
    const std::vector<double> expected{0, 1, 4, 1, 0, 0};
    for (std::size_t i = 0; i < knots.size(); ++i) CHECK_THAT(line.values[i], WithinAbs(expected[i], 1e-12));
    CHECK_THAT(line.derivatives[1].slope, WithinAbs(6. / 4, 1e-12));
    CHECK_THAT(line.derivatives[2].curving, WithinAbs(-12. / 4, 1e-12));
    // Between two knots the spline is the cubic of its four control points: 23/48 of the nearer ones, 1/48 of the
    // others.
    CHECK_THAT(between(spline, line, 1, 0.5), WithinAbs(6 * 23. / 48, 1e-12));
    CHECK_THAT(between(spline, line, 3, 0.5), WithinAbs(6 * 1. / 48, 1e-12));
}

TEST_CASE("Approximating splines of uneven knots are smooth") {
    const std::vector<double> knots = uneven_knots(9), values{0, 1, -1, 2, 0, 0, 0, 3, 1};
    const SplineAlong spline(knots, SliceSpline::approximating);
    const LineAlong line = spline.line(values);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        double fourth = 0;
        for (const auto& [k, weight] : {std::pair(0, 1), {1, -4}, {2, 6}, {3, -4}, {4, 1}})
            fourth += weight * between(spline, line, i, 0.25 * k);
        CHECK_THAT(fourth, WithinAbs(0, 1e-11));
    }
}

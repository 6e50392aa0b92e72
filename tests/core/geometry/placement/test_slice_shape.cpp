// Tests cross-sections between slices that are copies of one profile, or equal.
#include "geometry/placement/slice_shape.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/placement/spline_along.hpp"

using namespace contactd;
using namespace contactd::geometry;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Describes slices by corresponding points, and the lines along them.
struct Slices {
    SplineAlong spline;
    std::vector<SlicePoints> points;
    std::vector<LineAlong> lines{};

    Slices(SplineAlong along, std::vector<SlicePoints> of) : spline(std::move(along)), points(std::move(of)) {
        const std::vector<DerivativeShares> shares = spline.shares(points);
        for (std::size_t k = 0; k < points[0].size(); ++k) {
            std::vector<double> values;
            for (const SlicePoints& slice : points) values.push_back(slice[k]);
            lines.push_back(spline.line(std::move(values), shares));
        }
    }
    double at(std::size_t point, std::size_t piece, double share) const {
        const LineAlong& line = lines[point];
        const std::size_t next = (piece + 1) % points.size();
        return line.values[piece] +
               QuinticWeights::of_value(share, spline.width(piece))
                   .sum(line.values[next] - line.values[piece], line.derivatives[piece], line.derivatives[next]);
    }
};

std::vector<double> profile() {
    std::vector<double> z;
    for (double y = -35; y <= 35; y += 0.7) z.push_back(y * y / 600 + (y < -25 ? (y + 25) * (y + 25) / 20 : 0));
    return z;
}

template <class Widths = std::lognormal_distribution<>>
std::vector<double> uneven(std::mt19937& random, std::size_t count, Widths width = Widths(3, 1)) {
    std::vector<double> knots{-300};
    while (knots.size() < count) knots.push_back(knots.back() + width(random));
    return knots;
}

/// Lists measured, given and drawn heights: level, ramps, dips with a point, steps, and arbitrary ones.
std::vector<std::vector<double>> heights() {
    return {{0, 0, 0, 0.2, 1.8, 2, 2, 2},      {0, -1, -2, -3, -4, -5, -6, -7}, {0, 0, -1, -2, -1, 0, 0, 0},
            {0, 0, 0, 0.7, 0.7, 0.7, 0.7, 0},  {3, 1, 4, 1, 5, 9, 2, 6},        {0, 1e-3, 0, -1e-3, 5, 5, 5.001, 5},
            {0, 0.1, 0.3, 0.6, 1, 1.5, 2.1, 3}};
}

}  // namespace

TEST_CASE("Slices that are one profile at any heights are that profile all between") {
    std::mt19937 random(static_cast<unsigned>(GENERATE(range(1, 6))));
    const auto kind = GENERATE(SliceSpline::shape_preserving, SliceSpline::cubic, SliceSpline::approximating);
    const std::vector<double> z = profile();
    for (const std::vector<double>& height : heights()) {
        std::vector<SlicePoints> points;
        for (const double by : height) {
            points.emplace_back();
            for (const double at : z) points.back().push_back(at + by);
        }
        const Slices slices(SplineAlong(uneven(random, height.size()), kind), points);
        for (std::size_t piece = 0; piece + 1 < height.size(); ++piece)
            for (const double share : {0.1, 0.5, 0.85})
                for (std::size_t k = 1; k < z.size(); ++k)
                    REQUIRE_THAT(slices.at(k, piece, share) - slices.at(0, piece, share), WithinAbs(z[k] - z[0], 1e-9));
    }
}

TEST_CASE("Slices that are lifted, leaning and stretched copies of a profile are copies all between") {
    std::mt19937 random(static_cast<unsigned>(GENERATE(range(1, 6))));
    const auto kind = GENERATE(SliceSpline::shape_preserving, SliceSpline::cubic, SliceSpline::approximating);
    const std::vector<double> z = profile();
    std::uniform_real_distribution<> by(-1, 1);
    std::vector<SlicePoints> points;
    for (const double height : {0., 0., 1., 1.5, 1.5, 0., 2., 2.}) {
        points.emplace_back();
        const double leaning = 0.02 * by(random), stretched = 1 + 0.1 * by(random);
        for (std::size_t k = 0; k < z.size(); ++k)
            points.back().push_back(stretched * z[k] + leaning * static_cast<double>(k) + height);
    }
    const Slices slices(SplineAlong(uneven(random, points.size()), kind), points);
    // Copies are sums of 1, k and z[k] with the same factors for all k, which three of them determine.
    const auto lift = [&](std::size_t k, std::size_t piece, double share) { return slices.at(k, piece, share); };
    for (std::size_t piece = 0; piece + 1 < points.size(); ++piece)
        for (const double share : {0.15, 0.5, 0.8}) {
            const std::size_t a = 20, b = 50, c = 80;
            const double ua = static_cast<double>(a), ub = static_cast<double>(b), uc = static_cast<double>(c);
            const double rise = lift(b, piece, share) - lift(a, piece, share);
            const double other = lift(c, piece, share) - lift(b, piece, share);
            const double determinant = (ub - ua) * (z[c] - z[b]) - (uc - ub) * (z[b] - z[a]);
            const double leaning = (rise * (z[c] - z[b]) - other * (z[b] - z[a])) / determinant;
            const double stretched = ((ub - ua) * other - (uc - ub) * rise) / determinant;
            for (std::size_t k = 0; k < z.size(); ++k)
                REQUIRE_THAT(lift(k, piece, share) - lift(a, piece, share),
                             WithinAbs(leaning * (static_cast<double>(k) - ua) + stretched * (z[k] - z[a]), 1e-9));
        }
}

TEST_CASE("Digits that points are rounded to move what lies between by as little") {
    std::mt19937 random(static_cast<unsigned>(GENERATE(range(1, 6))));
    const double digit = GENERATE(1e-3, 1e-5);
    const std::vector<double> z = profile();
    for (const std::vector<double>& height : heights()) {
        std::vector<SlicePoints> points;
        std::uniform_real_distribution<> below(-0.5, 0.5);
        for (const double by : height) {
            points.emplace_back();
            for (const double at : z)  // rounded, and then measured again
                points.back().push_back(digit * std::round((at + by) / digit + below(random)));
        }
        const auto knots = uneven(random, height.size(), std::uniform_real_distribution<>(20, 60));
        const Slices slices(SplineAlong(knots, SliceSpline::shape_preserving), points);
        for (std::size_t piece = 0; piece + 1 < height.size(); ++piece)
            for (const double share : {0.1, 0.5, 0.85})
                for (std::size_t k = 1; k < z.size(); ++k)
                    REQUIRE_THAT(slices.at(k, piece, share) - slices.at(0, piece, share),
                                 WithinAbs(z[k] - z[0], 4 * digit));
        // Slices that are equal except for rounding are level between them.
        for (std::size_t piece = 0; piece + 1 < height.size(); ++piece)
            if (height[piece] == height[piece + 1])
                REQUIRE_THAT(slices.at(50, piece, 0.5), WithinAbs(z[50] + height[piece], 10 * digit));
    }
}

TEST_CASE("Slices that are equal are equal all between, whatever lies beside them and however far apart they are") {
    const double gap = GENERATE(0.1, 1.0, 30.0, 1e4), period = GENERATE(0.0, 50.0);
    const auto equal = GENERATE(EqualValues::stay, EqualValues::may_flank_extremum);
    // This dip is curved throughout, up to both of its ends.
    const std::vector<double> knots{0, 1, 2, 3, 4, 4 + gap, 5 + gap, 6 + gap};
    std::vector<SlicePoints> points;
    for (const double depth : {0.8, 0.9, 0.9, 0.6, 0.0, 0.0, 0.6, 0.9}) points.push_back({depth, 2 * depth, 1, -depth});
    if (equal == EqualValues::may_flank_extremum && gap <= 2) return;  // the curve may have one there
    const Slices slices(
        SplineAlong(knots, SliceSpline::shape_preserving, period > 0 ? knots.back() + period : 0, equal), points);
    for (std::size_t k = 0; k < 4; ++k)
        for (double share = 0; share < 1; share += 0.1) CHECK(slices.at(k, 4, share) == points[4][k]);
    if (equal == EqualValues::stay)
        for (double share = 0; share < 1; share += 0.1) CHECK(slices.at(1, 1, share) == points[1][1]);
}

TEST_CASE("Slices of a flat alone leave the rest of the turn as it is") {
    const auto kind = GENERATE(SliceSpline::shape_preserving, SliceSpline::cubic, SliceSpline::approximating);
    const double rest = GENERATE(0.0, 1e-7, 1e-3, -1e-3);  // deviation of the last slice
    std::vector<double> angles;
    std::vector<SlicePoints> points;
    for (int i = -10; i <= 10; ++i) {
        angles.push_back(0.006 * i);
        const double depth = 0.35 / 2 * (1 + std::cos(std::numbers::pi * i / 10)) - (i == 10 ? rest : 0);
        points.push_back({-depth, -depth, -depth});
    }
    const std::size_t last = points.size() - 1;
    const Slices slices(SplineAlong(angles, kind, turn, EqualValues::may_flank_extremum), points);
    for (double share = 0; share <= 1; share += 0.01)
        CHECK_THAT(slices.at(1, last, share), WithinAbs(std::lerp(rest, 0.0, share), std::abs(rest) + 1e-15));
    if (kind != SliceSpline::approximating)
        for (std::size_t piece = 0; piece < last; ++piece)
            CHECK_THAT(slices.at(0, piece, 0.5),
                       WithinAbs(-0.35 / 2 * (1 + std::cos(std::numbers::pi * (static_cast<int>(piece) - 9.5) / 10)),
                                 2e-3 + std::abs(rest)));
}

TEST_CASE("Two flats leave both parts between them as they are") {
    const auto kind = GENERATE(SliceSpline::shape_preserving, SliceSpline::cubic, SliceSpline::approximating);
    std::vector<double> angles;
    std::vector<SlicePoints> points;
    for (const double middle : {0.0, 2.5})
        for (int i = -6; i <= 6; ++i) {
            angles.push_back(middle + 0.01 * i);
            points.push_back({(0.2 + middle) * (std::abs(i) / 6. - 1), 0});
        }
    const Slices slices(SplineAlong(angles, kind, turn, EqualValues::may_flank_extremum), points);
    for (const std::size_t piece : {std::size_t{12}, points.size() - 1})
        for (double share = 0; share <= 1; share += 0.01) CHECK_THAT(slices.at(0, piece, share), WithinAbs(0, 1e-15));
}

TEST_CASE("A smooth wheel has its lowest place between two slices that are equal") {
    std::vector<double> angles;
    std::vector<SlicePoints> points;
    for (int i = -5; i <= 6; ++i) {
        angles.push_back(0.006 * (i - 0.5));
        points.push_back({angles.back() * angles.back(), 2 * angles.back() * angles.back()});
    }
    const Slices slices(SplineAlong(angles, SliceSpline::shape_preserving, turn, EqualValues::may_flank_extremum),
                        points);
    CHECK_THAT(slices.at(0, 5, 0.5), WithinAbs(0, 1e-12));
    CHECK_THAT(slices.at(1, 5, 0.5), WithinAbs(0, 1e-12));
}

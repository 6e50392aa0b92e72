// Extends the smallest ball around few points on its surface to the farthest point outside, until there is none
// (Fischer, Gaertner and Kutz 2003). All subsets of the few points are tried to find those that remain: there are at
// most six of them in five dimensions.
#include "smallest_ball.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace contactd {
namespace {

constexpr double rounding = 1e-9;  // relative to a radius
constexpr int most_rounds = 200;

double squared_distance(const DeviatorPoint& a, const DeviatorPoint& b) {
    double sum = 0;
    for (std::size_t c = 0; c < a.size(); ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

double product(const DeviatorPoint& a, const DeviatorPoint& b) {
    double sum = 0;
    for (std::size_t c = 0; c < a.size(); ++c) sum += a[c] * b[c];
    return sum;
}

using Row = std::array<double, 6>;  // equation for at most five numbers; the last entry is its right side

/// Solves by Gauss's elimination; returns nothing if the matrix is singular.
std::optional<std::array<double, 5>> solved(std::array<Row, 5> rows, std::size_t n) {
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(rows[i][i]));
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
        if (!(std::abs(rows[pivot][k]) > 1e-12 * largest)) return std::nullopt;
        std::swap(rows[k], rows[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j < n; ++j) rows[i][j] -= factor * rows[k][j];
            rows[i][5] -= factor * rows[k][5];
        }
    }
    std::array<double, 5> result{};
    for (std::size_t k = n; k-- > 0;) {
        double sum = rows[k][5];
        for (std::size_t j = k + 1; j < n; ++j) sum -= rows[k][j] * result[j];
        result[k] = sum / rows[k][k];
    }
    return result;
}

/// Returns the ball with all of the points on its surface and the centre between them, or nothing if there is none.
std::optional<Ball> ball_through(const DeviatorPoint& first, std::span<const DeviatorPoint> others) {
    std::array<DeviatorPoint, 5> edges{};
    std::array<Row, 5> rows{};
    const std::size_t n = others.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t c = 0; c < first.size(); ++c) edges[i][c] = others[i][c] - first[c];
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) rows[i][j] = 2 * product(edges[i], edges[j]);
        rows[i][5] = product(edges[i], edges[i]);
    }
    const auto weights = solved(rows, n);
    if (!weights) return std::nullopt;
    double rest = 1;
    Ball ball{first};
    for (std::size_t i = 0; i < n; ++i) {
        const double weight = (*weights)[i];
        if (weight < -rounding) return std::nullopt;
        rest -= weight;
        for (std::size_t c = 0; c < first.size(); ++c) ball.centre[c] += weight * edges[i][c];
    }
    if (rest < -rounding) return std::nullopt;
    ball.radius = std::sqrt(squared_distance(ball.centre, first));
    return ball;
}

bool holds(const Ball& ball, const DeviatorPoint& point) {
    const double radius = ball.radius * (1 + rounding);
    return squared_distance(ball.centre, point) <= radius * radius;
}

}  // namespace

Ball smallest_ball(std::span<const DeviatorPoint> points) {
    std::vector<DeviatorPoint> surface;  // points that determine the ball
    Ball ball{points.front()};
    for (int round = 0; round < most_rounds; ++round) {
        std::size_t farthest = 0;
        double distance = -1;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const double d = squared_distance(ball.centre, points[i]); d > distance) {
                distance = d;
                farthest = i;
            }
        const DeviatorPoint& outside = points[farthest];
        if (holds(ball, outside)) return ball;
        if (surface.empty()) surface.push_back(points.front());
        // The farthest point lies on the surface of the ball around it and the previous points.
        std::vector<DeviatorPoint> best_surface;
        Ball best{outside, std::numeric_limits<double>::infinity()};
        for (std::size_t subset = 1; subset < (std::size_t{1} << surface.size()); ++subset) {
            std::vector<DeviatorPoint> chosen;
            for (std::size_t i = 0; i < surface.size(); ++i)
                if ((subset >> i & 1) != 0) chosen.push_back(surface[i]);
            if (chosen.size() > 5) continue;
            const auto tried = ball_through(outside, chosen);
            if (!tried || tried->radius >= best.radius) continue;
            bool around_all = true;
            for (const DeviatorPoint& point : surface) around_all = around_all && holds(*tried, point);
            if (!around_all) continue;
            best = *tried;
            best_surface = std::move(chosen);
            best_surface.push_back(outside);
        }
        if (best_surface.empty()) {  // Rounding errors occur if points nearly lie on one ball.
            ball.radius = std::sqrt(distance);
            return ball;
        }
        ball = best;
        surface = std::move(best_surface);
    }
    return ball;
}

}  // namespace contactd

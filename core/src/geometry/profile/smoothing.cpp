#include "geometry/profile/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace contactd::geometry {
namespace {

/// Holds rows of a symmetric matrix with `count` bands on either side of the diagonal: its (i, i) to (i, i + count).
template <std::size_t count>
using Bands = std::vector<std::array<double, count + 1>>;

/// Solves a positive definite system by L D L^T in place.
template <std::size_t count>
std::vector<double> solved(Bands<count> bands, std::vector<double> right) {
    const std::size_t n = bands.size();
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = bands[i];
        for (std::size_t k = 1; k <= count && i + k < n; ++k) {
            const double factor = row[k] / row[0];
            for (std::size_t j = k; j <= count; ++j) bands[i + k][j - k] -= factor * row[j];
            right[i + k] -= factor * right[i];
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = 1; k <= count && i + k < n; ++k) right[i] -= bands[i][k] * right[i + k];
        right[i] /= bands[i][0];
    }
    return right;
}

/// Returns the four cubic B-splines of an interval, with `t` along it from 0 to 1.
std::array<double, 4> b_splines(double t) {
    const double rest = 1 - t;
    return {rest * rest * rest / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
            (3 * rest * rest * rest - 6 * rest * rest + 4) / 6, t * t * t / 6};
}

}  // namespace

double lambda_of(double wavelength) {
    return std::pow(wavelength, 4) / (16 * std::pow(std::numbers::pi, 4));
}

double wavelength_of(double lambda) {
    return 2 * std::numbers::pi * std::pow(lambda, 0.25);
}

std::vector<double> smoothed(std::span<const double> knots, std::span<const double> values,
                             std::span<const double> weights, double lambda) {
    const std::size_t n = knots.size();
    std::vector<double> smooth(values.begin(), values.end());
    if (n < 3 || lambda == 0) return smooth;
    // Column i of Q converts values to the change of slope at knot i + 1: (R + lambda Q^T W^-1 Q) f'' = Q^T values.
    std::vector<std::array<double, 3>> differences(n - 2);
    Bands<2> bands(n - 2);
    std::vector<double> right(n - 2);
    for (std::size_t i = 0; i + 2 < n; ++i) {
        const double before = knots[i + 1] - knots[i], behind = knots[i + 2] - knots[i + 1];
        differences[i] = {1 / before, -1 / before - 1 / behind, 1 / behind};
        bands[i] = {(before + behind) / 3, i + 3 < n ? behind / 6 : 0, 0};
        for (std::size_t k = 0; k < 3; ++k) right[i] += differences[i][k] * values[i + k];
    }
    for (std::size_t i = 0; i + 2 < n; ++i)
        for (std::size_t k = 0; k < 3 && i + k + 2 < n; ++k)
            for (std::size_t at = k; at < 3; ++at)  // knots that both differences share
                bands[i][k] += lambda * differences[i][at] * differences[i + k][at - k] / weights[i + at];
    const auto curving = solved<2>(std::move(bands), std::move(right));
    for (std::size_t i = 0; i + 2 < n; ++i)
        for (std::size_t k = 0; k < 3; ++k) smooth[i + k] -= lambda * differences[i][k] * curving[i] / weights[i + k];
    return smooth;
}

std::vector<double> smoothed_by_third(std::span<const double> knots, std::span<const double> values,
                                      std::span<const double> weights, double wavelength) {
    const std::size_t n = knots.size();
    std::vector<double> smooth(values.begin(), values.end());
    const double length = n > 0 ? knots[n - 1] - knots[0] : 0;
    if (n < 4 || !(wavelength > 0 && length > 0)) return smooth;
    const auto intervals = static_cast<std::size_t>(std::max(1.0, std::ceil(4 * length / wavelength - 1e-9)));
    const double step = length / static_cast<double>(intervals);
    Bands<3> bands(intervals + 3);
    std::vector<double> right(intervals + 3);
    struct Place {
        std::size_t interval;
        std::array<double, 4> shares;
    };
    std::vector<Place> places;
    for (std::size_t i = 0; i < n; ++i) {
        const double along = (knots[i] - knots[0]) / step;
        const auto interval = std::min(static_cast<std::size_t>(along), intervals - 1);
        const auto& [at, shares] =
            places.emplace_back(Place{interval, b_splines(along - static_cast<double>(interval))});
        for (std::size_t k = 0; k < 4; ++k) {
            right[at + k] += weights[i] * shares[k] * values[i];
            for (std::size_t j = k; j < 4; ++j) bands[at + k][j - k] += weights[i] * shares[k] * shares[j];
        }
    }
    // The third derivative is constant on an interval.
    constexpr std::array<double, 4> third{-1, 3, -3, 1};
    const double factor = std::pow(wavelength / (2 * std::numbers::pi * step), 6) * step;
    for (std::size_t interval = 0; interval < intervals; ++interval)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t j = k; j < 4; ++j) bands[interval + k][j - k] += factor * third[k] * third[j];
    const auto coefficients = solved<3>(std::move(bands), std::move(right));
    for (std::size_t i = 0; i < n; ++i) {
        smooth[i] = 0;
        for (std::size_t k = 0; k < 4; ++k) smooth[i] += places[i].shares[k] * coefficients[places[i].interval + k];
    }
    return smooth;
}

}  // namespace contactd::geometry

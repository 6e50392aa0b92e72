#include "geometry/profile/smoothing.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace contactd::geometry {
namespace {

/// Solves a symmetric, positive definite system with two bands on either side of the diagonal, by L D L^T in place.
/// bands[i] holds the matrix's (i, i), (i, i+1) and (i, i+2).
std::vector<double> solved(std::vector<std::array<double, 3>> bands, std::vector<double> right) {
    const std::size_t n = bands.size();
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = bands[i];
        for (std::size_t k = 1; k <= 2 && i + k < n; ++k) {
            const double factor = row[k] / row[0];
            for (std::size_t j = k; j <= 2; ++j) bands[i + k][j - k] -= factor * row[j];
            right[i + k] -= factor * right[i];
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = 1; k <= 2 && i + k < n; ++k) right[i] -= bands[i][k] * right[i + k];
        right[i] /= bands[i][0];
    }
    return right;
}

}  // namespace

double lambda_of(double wavelength) {
    return std::pow(wavelength, 4) / (16 * std::pow(std::numbers::pi, 4));
}

std::vector<double> smoothed(std::span<const double> knots, std::span<const double> values,
                             std::span<const double> weights, double lambda) {
    const std::size_t n = knots.size();
    std::vector<double> smooth(values.begin(), values.end());
    if (n < 3 || lambda == 0) return smooth;
    // Column i of Q takes values to the change of slope at knot i + 1: (R + lambda Q^T W^-1 Q) f'' = Q^T values.
    std::vector<std::array<double, 3>> differences(n - 2), bands(n - 2);
    std::vector<double> right(n - 2);
    for (std::size_t i = 0; i + 2 < n; ++i) {
        const double before = knots[i + 1] - knots[i], behind = knots[i + 2] - knots[i + 1];
        differences[i] = {1 / before, -1 / before - 1 / behind, 1 / behind};
        bands[i] = {(before + behind) / 3, i + 3 < n ? behind / 6 : 0, 0};
        for (std::size_t k = 0; k < 3; ++k) right[i] += differences[i][k] * values[i + k];
    }
    for (std::size_t i = 0; i + 2 < n; ++i)
        for (std::size_t k = 0; k < 3 && i + k + 2 < n; ++k)
            for (std::size_t at = k; at < 3; ++at)  // of the knots that both differences have
                bands[i][k] += lambda * differences[i][at] * differences[i + k][at - k] / weights[i + at];
    const auto curving = solved(std::move(bands), std::move(right));
    for (std::size_t i = 0; i + 2 < n; ++i)
        for (std::size_t k = 0; k < 3; ++k) smooth[i + k] -= lambda * differences[i][k] * curving[i] / weights[i + k];
    return smooth;
}

}  // namespace contactd::geometry

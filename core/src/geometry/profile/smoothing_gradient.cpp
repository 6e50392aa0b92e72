#include "geometry/profile/smoothing_gradient.hpp"

#include <cstddef>

#include "geometry/profile/smoothing.hpp"

namespace contactd::geometry {
namespace {

/// Returns second derivatives at the knots of the natural spline through values of smoothed(), or of its transpose: the
/// solution x of (R + lambda Q^T W^-1 Q) x = Q^T values, from W (values - smooth) = lambda Q x.
std::vector<double> curving_of(std::span<const double> knots, std::span<const double> values,
                               const std::vector<double>& smooth, std::span<const double> weights, double lambda) {
    const std::size_t n = knots.size();
    std::vector<double> curving(n, 0.0);
    double slope = 0;  // change of slope of x, which W (values - smooth) / lambda sums up to
    for (std::size_t i = 0; i + 1 < n; ++i) {
        slope += weights[i] * (values[i] - smooth[i]) / lambda;
        curving[i + 1] = curving[i] + slope * (knots[i + 1] - knots[i]);
    }
    return curving;
}

}  // namespace

// With x and a the solutions for the values and for their gradient, smooth = v - lambda W^-1 Q x. The matrices R, Q and
// the weights depend on the widths h. The operator of `smoothed` is W^-1 times a symmetric one.
SmoothingGradient smoothing_gradient(std::span<const double> knots, std::span<const double> values,
                                     std::span<const double> weights, double lambda,
                                     std::span<const double> by_smoothed) {
    const std::size_t n = knots.size();
    SmoothingGradient by{{by_smoothed.begin(), by_smoothed.end()}, std::vector<double>(n, 0.0), {}};
    by.widths.assign(n > 0 ? n - 1 : 0, 0.0);
    if (n < 3 || lambda == 0) return by;
    std::vector<double> scaled;
    for (std::size_t i = 0; i < n; ++i) scaled.push_back(by_smoothed[i] / weights[i]);
    const std::vector<double> smooth = smoothed(knots, values, weights, lambda);
    const std::vector<double> by_scaled = smoothed(knots, scaled, weights, lambda);
    const std::vector<double> x = curving_of(knots, values, smooth, weights, lambda);
    const std::vector<double> a = curving_of(knots, scaled, by_scaled, weights, lambda);
    for (std::size_t i = 0; i < n; ++i) {
        by.values[i] = weights[i] * by_scaled[i];
        by.weights[i] = by_scaled[i] * (values[i] - smooth[i]);
    }
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double h = knots[i + 1] - knots[i], over = lambda / (h * h);
        by.widths[i] = -over * ((a[i + 1] - a[i]) * (smooth[i + 1] - smooth[i]) +
                                (x[i + 1] - x[i]) * (by_scaled[i + 1] - by_scaled[i])) +
                       lambda * ((a[i] * x[i] + a[i + 1] * x[i + 1]) / 3 + (a[i] * x[i + 1] + a[i + 1] * x[i]) / 6);
    }
    return by;
}

}  // namespace contactd::geometry

// Cubic smoothing splines.
#pragma once

#include <span>
#include <vector>

namespace contactd::geometry {

/// Values at the knots of the natural cubic spline f that makes sum w (f - value)^2 + lambda * integral f''^2 least
/// (Reinsch 1967). The knots ascend, the weights are positive.
std::vector<double> smoothed(std::span<const double> knots, std::span<const double> values,
                             std::span<const double> weights, double lambda);

/// lambda for weights of the points' distances: a wave of this length keeps half its amplitude.
double lambda_of(double wavelength);

}  // namespace contactd::geometry

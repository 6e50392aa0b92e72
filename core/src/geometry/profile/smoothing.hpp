// Computes smoothing splines.
#pragma once

#include <span>
#include <vector>

namespace contactd::geometry {

/// Returns values at the knots of the natural cubic spline f that minimises sum w (f - value)^2 + lambda * integral
/// f''^2 (Reinsch 1967). The knots ascend, and the weights are positive.
std::vector<double> smoothed(std::span<const double> knots, std::span<const double> values,
                             std::span<const double> weights, double lambda);

/// Returns lambda for weights equal to the points' distances, so that a wave of this length keeps half its amplitude.
double lambda_of(double wavelength);
/// Returns the wavelength for lambda, for weights that are distances on average.
double wavelength_of(double lambda);

/// Returns values at the knots of the cubic spline f, on intervals of at most a quarter of the wavelength, that
/// minimises sum w (f - value)^2 + (wavelength / 2 pi)^6 * integral f'''^2. Arcs of a circle keep more of their shape
/// than with the second derivative. With weights equal to the points' distances, a wave of this length keeps 45 % of
/// its amplitude, one of twice the length 98 %, and one of half the length almost nothing.
std::vector<double> smoothed_by_third(std::span<const double> knots, std::span<const double> values,
                                      std::span<const double> weights, double wavelength);

}  // namespace contactd::geometry

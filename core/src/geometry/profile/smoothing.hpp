// Smoothing splines.
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
/// The reverse, of weights that are distances in the mean.
double wavelength_of(double lambda);

/// Values at the knots of the cubic spline f, on intervals of a quarter of the wavelength at most, that makes
/// sum w (f - value)^2 + (wavelength / 2 pi)^6 * integral f'''^2 least: arcs of a circle keep more of their shape. With
/// weights of the points' distances a wave of this length keeps 45 % of its amplitude, one of twice the length 98 %,
/// one of half the length none.
std::vector<double> smoothed_by_third(std::span<const double> knots, std::span<const double> values,
                                      std::span<const double> weights, double wavelength);

}  // namespace contactd::geometry

// Computes gradients through smoothing splines.
#pragma once

#include <span>
#include <vector>

namespace contactd::geometry {

struct SmoothingGradient {
    std::vector<double> values, weights;  ///< by those at the knots
    std::vector<double> widths;           ///< by the distances of neighbouring knots
};

/// Returns the gradient by the arguments of smoothed() from that by its result.
SmoothingGradient smoothing_gradient(std::span<const double> knots, std::span<const double> values,
                                     std::span<const double> weights, double lambda,
                                     std::span<const double> by_smoothed);

}  // namespace contactd::geometry

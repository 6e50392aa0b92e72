// Fits uniform cubic B-splines to values at their knots.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace contactd::creep_table {

/// States what determines a spline at one of its ends beside the value there.
enum class SplineEnd {
    not_a_knot,   ///< the third derivative is continuous at the next knot
    slope,        ///< the slope is given
    even,         ///< the function is symmetric about the end
    odd,          ///< the function is antisymmetric about the end, where it must be given as zero
    antiperiodic  ///< the function changes its sign after this period; for both ends
};

/// Returns the matrix that makes the n + 3 coefficients of a spline from n + 3 data: the slope at the first end times
/// the step, or zero, the n + 1 values at the knots, and the same slope at the last end. n >= 4.
Eigen::MatrixXd spline_fit(int cells, SplineEnd first, SplineEnd last);

/// Multiplies `matrix` with an array of shape [before, matrix.cols(), after] along its middle axis.
std::vector<double> multiply_along(const Eigen::MatrixXd& matrix, const std::vector<double>& array, std::size_t after);

/// Inserts zeros before and behind the middle axis of an array of shape [before, nodes, after]: data of ends that are
/// not slopes.
std::vector<double> with_zero_ends(const std::vector<double>& array, int nodes, std::size_t after);

}  // namespace contactd::creep_table

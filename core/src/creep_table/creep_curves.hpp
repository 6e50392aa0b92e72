// Holds what scales creepages and what forces are at small creepage, as splines over log(a/b) at one Poisson's ratio.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "creep_table/full_slip.hpp"
#include "creep_table/spline_axis.hpp"

namespace contactd::creep_table {

/// The curves in the order of a file: the inverses of the creepages of full slip, and Kalker's coefficients.
enum Curve : int { inverse_xi, inverse_eta, inverse_phi, C11, C22, C23, C33, curve_count };

/// Returns the coefficients of all curves, of shape [curve_count, axis.coefficients()]. Throws InvalidArgument
/// ("a_over_b") outside Kalker's coefficients.
std::vector<double> creep_curves(const SplineAxis& axis, double nu);

/// Evaluates the coefficients of creep_curves at one log(a/b).
class CurvePoint {
   public:
    CurvePoint(std::span<const double> curves, const SplineAxis& axis, double log_ratio)
        : first_(curves.data()), stride_(axis.coefficients()), weights_(axis, log_ratio) {}

    double value(int curve) const { return sum(curve, weights_.value); }
    double slope(int curve) const { return sum(curve, weights_.slope); }

   private:
    double sum(int curve, const double (&weights)[4]) const {
        const double* const knots = first_ + curve * stride_ + weights_.cell;
        return weights[0] * knots[0] + weights[1] * knots[1] + weights[2] * knots[2] + weights[3] * knots[3];
    }

    const double* first_;
    int stride_;
    SplineWeights<double> weights_;
};

/// Returns the derivatives of (Fx, Fy, Mz/c)/(mu Fn) by (xi, eta, phi c) G c^2/(mu Fn) without creepage, by rows.
inline std::array<Triple, 3> creepage_matrix(double C11, double C22, double C23, double C33) {
    return {{{C11, 0, 0}, {0, C22, C23}, {0, -C23, C33}}};
}

}  // namespace contactd::creep_table

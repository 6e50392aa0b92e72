// Computes Kalker's creepage and spin coefficients: rolling contact of an ellipse in the limit of small creepage
// (Kalker 1967; Kalker 1990, section 3.1 and table E.3).
#pragma once

#include "contactd/gap.hpp"
#include "contactd/material.hpp"

namespace contactd {

/// Holds the dimensionless coefficients. With c^2 = ab, rolling along x: Fx = -G c^2 C11 xi, Fy = -G c^2 (C22 eta + c
/// C23 phi), Mz = -G c^3 (C32 eta + c C33 phi), C32 = -C23.
struct KalkerCoefficients {
    double C11, C22, C23, C33;
};

/// Returns the coefficients, interpolated in log(a/b) and nu in a table that bench/kalker_coefficients.py computed. For
/// a/b from 1/10 to 10 and nu from 0 to 0.5, the error of the table is about 3e-4, as estimated from its convergence.
/// The error of C23 is about 2e-3 at a/b < 0.3 and 5e-3 at 1/32. Interpolation adds less than 1e-4. a is the semi-axis
/// along the rolling direction, and 0 <= nu <= 0.5. Throws InvalidArgument ("a_over_b") outside the table, which ranges
/// from 1/32 to 32.
KalkerCoefficients kalker_coefficients(double a_over_b, double nu);

bool has_kalker_coefficients(double a_over_b);

}  // namespace contactd

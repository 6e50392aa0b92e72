// Kalker's creepage coefficients as his book prints them (Kalker 1990, table E.3), to three digits.
#pragma once

#include "closed_forms/kalker_coefficients.hpp"

namespace contactd {

/// Between the lines of the table, of the smaller axis over the larger one in steps of 0.1, coefficients are linear;
/// between its columns, of nu = 0, 1/4 and 1/2, their inverses are parabolas. Beyond 1/10 and 10 the last line holds.
/// a is the semi-axis along the rolling direction. Within 2 per cent of kalker_coefficients, but for C33.
KalkerCoefficients printed_coefficients(double a_over_b, double nu);

}  // namespace contactd

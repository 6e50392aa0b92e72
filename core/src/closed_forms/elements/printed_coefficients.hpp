// Interpolates Kalker's creepage coefficients as printed in his book (Kalker 1990, table E.3), to three digits.
#pragma once

#include "closed_forms/kalker_coefficients.hpp"

namespace contactd {

/// Returns the coefficients. They are linear between the lines of the table, which are for the smaller axis over the
/// larger one in steps of 0.1. Between its columns, for nu = 0, 1/4 and 1/2, their inverses are parabolas. Beyond 1/10
/// and 10 the last line applies. a is the semi-axis along the rolling direction. Except for C33, they are within 2 per
/// cent of kalker_coefficients.
KalkerCoefficients printed_coefficients(double a_over_b, double nu);

}  // namespace contactd

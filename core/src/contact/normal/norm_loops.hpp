// Implements the loops of NORM over its elements without branches. Arrays have n values and do not overlap.
#pragma once

#include <cstddef>

namespace contactd {

/// Holds pressures and their effects: `in` is 1 in the contact set and 0 outside, the gap is u + h - approach, and r is
/// minus the gap within the set.
struct NormState {
    std::size_t n;
    const double *in, *h;
    double *p, *u, *r;
};

/// Holds sums over elements; squares are in mm^2, except that of suction, which is of pressures.
struct NormViolations {
    double defect = 0;     ///< r^2
    double reference = 0;  ///< (h - approach)^2 within the set
    double suction = 0;    ///< p^2 where p < 0
    double overlap = 0;    ///< gap^2 outside the set where the gap is below minus `rounding` times its terms
};
/// Computes p += alpha v, u += alpha q, then r; evaluates the contact conditions there.
NormViolations advance(const NormState& state, double alpha, const double* v, const double* q, double approach,
                       double rounding);

/// Returns the mean of u + h over the set.
double mean_distance(const NormState& state);
/// Returns p . (u/2 + h).
double potential(const NormState& state);

/// Computes v = in z + beta v.
void update_direction(std::size_t n, const double* in, const double* z, double beta, double* v);
/// Computes y += factor x.
void add_multiple(std::size_t n, double factor, const double* x, double* y);
/// Returns the sum of a b c.
double triple_product(std::size_t n, const double* a, const double* b, const double* c);

/// Holds the slope along a direction v with q = A v.
struct NormSlope {
    double curvature = 0;  ///< v . q
    double slope = 0;      ///< r . v
    double rise = 0;       ///< sum of q over the set
    double count = 0;      ///< number of elements in the set
};
NormSlope slope_along(const NormState& state, const double* v, const double* q);

}  // namespace contactd

// Products of transformed fields with symbols. Fields are n complex numbers, real and imaginary parts in turns.
#pragma once

#include <cstddef>

namespace contactd {

/// (x, y) = [[xx, xy], [yx, yy]] (x, y), the symbols real.
void multiply_pair(std::size_t n, double* x, double* y, const double* xx, const double* xy, const double* yx,
                   const double* yy);

struct ComplexFactor {
    const double *real, *imag;
};
/// The same with complex symbols.
void multiply_pair(std::size_t n, double* x, double* y, const ComplexFactor& xx, const ComplexFactor& xy,
                   const ComplexFactor& yx, const ComplexFactor& yy);

}  // namespace contactd

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
/// x = symbol x
void multiply(std::size_t n, double* x, const ComplexFactor& symbol);
/// Multiplies by complex symbols.
void multiply_pair(std::size_t n, double* x, double* y, const ComplexFactor& xx, const ComplexFactor& xy,
                   const ComplexFactor& yx, const ComplexFactor& yy);

/// Two real fields as the real and the imaginary part of a complex one, to and fro: the complex transform of n numbers
/// holds both transforms, of which the first n/2 + 1 numbers are wanted.
void interleave(std::size_t n, const double* x, const double* y, double* both);
void deinterleave(std::size_t n, const double* both, double* x, double* y);
void split_transforms(std::size_t n, const double* both, double* x, double* y);
void join_transforms(std::size_t n, const double* x, const double* y, double* both);

}  // namespace contactd

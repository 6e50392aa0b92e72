// Computes products of matrices with waves, four wavenumbers at a time. Matrices are as in strip_symbols.hpp.
#pragma once

#include <cstddef>

#include "strip_fft.hpp"

namespace contactd {

/// Holds the range of strips that a matrix keeps in a pair of its rows.
struct EntryRange {
    std::size_t begin = 0, end = 0;
};

/// Compute out = M in for a symmetric matrix with n entries; `begin` holds the first kept strip of each pair of rows.
void multiply_symmetric(std::size_t n, const std::size_t* begin, const double* matrix, const double* in_re,
                        const double* in_im, double* out_re, double* out_im);
void multiply_symmetric(std::size_t n, const std::size_t* begin, const float* matrix, const double* in_re,
                        const double* in_im, double* out_re, double* out_im);
/// Multiply by any other matrix; `kept` holds the range of each pair of rows.
void multiply_rows(std::size_t rows, const EntryRange* kept, const double* matrix, const double* in_re,
                   const double* in_im, double* out_re, double* out_im);
void multiply_rows(std::size_t rows, const EntryRange* kept, const float* matrix, const double* in_re,
                   const double* in_im, double* out_re, double* out_im);
/// Compute out = M' in.
void multiply_columns(std::size_t rows, std::size_t columns, const EntryRange* kept, const double* matrix,
                      const double* in_re, const double* in_im, double* out_re, double* out_im);
void multiply_columns(std::size_t rows, std::size_t columns, const EntryRange* kept, const float* matrix,
                      const double* in_re, const double* in_im, double* out_re, double* out_im);

}  // namespace contactd

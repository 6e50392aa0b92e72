// Products of matrices with waves, four wavenumbers at a time. Matrices are as those of strip_symbols.hpp.
#pragma once

#include <cstddef>

#include "strip_fft.hpp"

namespace contactd {

/// Strips of a matrix that are kept of a pair of its rows.
struct EntryRange {
    std::size_t begin = 0, end = 0;
};

/// out = M in, of a symmetric one: n entries, `begin` of each pair of rows the first strip that is kept.
void multiply_symmetric(std::size_t n, const std::size_t* begin, const double* matrix, const double* in_re,
                        const double* in_im, double* out_re, double* out_im);
void multiply_symmetric(std::size_t n, const std::size_t* begin, const float* matrix, const double* in_re,
                        const double* in_im, double* out_re, double* out_im);
/// Multiplies by any other matrix, `kept` of each pair of rows.
void multiply_rows(std::size_t rows, const EntryRange* kept, const double* matrix, const double* in_re,
                   const double* in_im, double* out_re, double* out_im);
void multiply_rows(std::size_t rows, const EntryRange* kept, const float* matrix, const double* in_re,
                   const double* in_im, double* out_re, double* out_im);
/// out = M' in
void multiply_columns(std::size_t rows, std::size_t columns, const EntryRange* kept, const double* matrix,
                      const double* in_re, const double* in_im, double* out_re, double* out_im);
void multiply_columns(std::size_t rows, std::size_t columns, const EntryRange* kept, const float* matrix,
                      const double* in_re, const double* in_im, double* out_re, double* out_im);

}  // namespace contactd

#include "strip_kernels.hpp"

#include <algorithm>

#include "types/simd.hpp"

namespace contactd {
namespace {

constexpr std::size_t lanes = Waves::lanes;

// Each Four holds adjacent wavenumbers.
[[gnu::always_inline]] inline void load(const double* values, Four& loaded) {
    loaded = four(values);
}
[[gnu::always_inline]] inline void load(const float* values, Four& loaded) {
    using FourFloats [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
    loaded = __builtin_convertvector(*reinterpret_cast<const FourFloats*>(values), Four);
}

// Processes two rows at a time, with their products by the strips before them and the transposed ones; `begin` has an
// entry for each pair.
template <class Number>
[[gnu::always_inline]] inline void symmetric(std::size_t n, const std::size_t* begin, const Number* matrix,
                                             const double* in_re, const double* in_im, double* out_re, double* out_im) {
    for (std::size_t row = 0; row < n * lanes; row += 2 * lanes, ++begin) {
        const Four a_re = four(in_re + row), a_im = four(in_im + row);
        const Four b_re = four(in_re + row + lanes), b_im = four(in_im + row + lanes);
        Four to_a_re = {}, to_a_im = {}, to_b_re = {}, to_b_im = {};
        for (std::size_t column = *begin * lanes; column < row; column += lanes, matrix += 2 * lanes) {
            Four of_a, of_b;
            load(matrix, of_a);
            load(matrix + lanes, of_b);
            const Four re = four(in_re + column), im = four(in_im + column);
            to_a_re += of_a * re;
            to_a_im += of_a * im;
            to_b_re += of_b * re;
            to_b_im += of_b * im;
            four(out_re + column) += of_a * a_re + of_b * b_re;
            four(out_im + column) += of_a * a_im + of_b * b_im;
        }
        Four aa, ab, bb;
        load(matrix, aa);
        load(matrix + lanes, ab);
        load(matrix + 2 * lanes, bb);
        matrix += 3 * lanes;
        four(out_re + row) = to_a_re + aa * a_re + ab * b_re;
        four(out_im + row) = to_a_im + aa * a_im + ab * b_im;
        four(out_re + row + lanes) = to_b_re + ab * a_re + bb * b_re;
        four(out_im + row + lanes) = to_b_im + ab * a_im + bb * b_im;
    }
}

// Multiplies by rows; `kept` has an entry for each pair of rows.
template <class Number>
[[gnu::always_inline]] inline void by_rows(std::size_t rows, const EntryRange* kept, const Number* matrix,
                                           const double* in_re, const double* in_im, double* out_re, double* out_im) {
    for (std::size_t row = 0; row < rows * lanes; row += 2 * lanes, ++kept) {
        Four a_re = {}, a_im = {}, b_re = {}, b_im = {};
        for (std::size_t column = kept->begin * lanes; column < kept->end * lanes; column += lanes) {
            Four a, b;
            load(matrix, a);
            load(matrix + lanes, b);
            matrix += 2 * lanes;
            const Four re = four(in_re + column), im = four(in_im + column);
            a_re += a * re;
            a_im += a * im;
            b_re += b * re;
            b_im += b * im;
        }
        four(out_re + row) = a_re;
        four(out_im + row) = a_im;
        four(out_re + row + lanes) = b_re;
        four(out_im + row + lanes) = b_im;
    }
}

template <class Number>
[[gnu::always_inline]] inline void by_columns(std::size_t rows, std::size_t columns, const EntryRange* kept,
                                              const Number* matrix, const double* in_re, const double* in_im,
                                              double* out_re, double* out_im) {
    std::fill_n(out_re, columns * lanes, 0.0);
    std::fill_n(out_im, columns * lanes, 0.0);
    for (std::size_t row = 0; row < rows * lanes; row += 2 * lanes, ++kept) {
        const Four a_re = four(in_re + row), a_im = four(in_im + row);
        const Four b_re = four(in_re + row + lanes), b_im = four(in_im + row + lanes);
        for (std::size_t column = kept->begin * lanes; column < kept->end * lanes; column += lanes) {
            Four a, b;
            load(matrix, a);
            load(matrix + lanes, b);
            matrix += 2 * lanes;
            four(out_re + column) += a * a_re + b * b_re;
            four(out_im + column) += a * a_im + b * b_im;
        }
    }
}

}  // namespace

CONTACTD_SIMD
void multiply_symmetric(std::size_t n, const std::size_t* begin, const double* matrix, const double* in_re,
                        const double* in_im, double* out_re, double* out_im) {
    symmetric(n, begin, matrix, in_re, in_im, out_re, out_im);
}
CONTACTD_SIMD
void multiply_symmetric(std::size_t n, const std::size_t* begin, const float* matrix, const double* in_re,
                        const double* in_im, double* out_re, double* out_im) {
    symmetric(n, begin, matrix, in_re, in_im, out_re, out_im);
}

CONTACTD_SIMD
void multiply_rows(std::size_t rows, const EntryRange* kept, const double* matrix, const double* in_re,
                   const double* in_im, double* out_re, double* out_im) {
    by_rows(rows, kept, matrix, in_re, in_im, out_re, out_im);
}
CONTACTD_SIMD
void multiply_rows(std::size_t rows, const EntryRange* kept, const float* matrix, const double* in_re,
                   const double* in_im, double* out_re, double* out_im) {
    by_rows(rows, kept, matrix, in_re, in_im, out_re, out_im);
}

CONTACTD_SIMD
void multiply_columns(std::size_t rows, std::size_t columns, const EntryRange* kept, const double* matrix,
                      const double* in_re, const double* in_im, double* out_re, double* out_im) {
    by_columns(rows, columns, kept, matrix, in_re, in_im, out_re, out_im);
}
CONTACTD_SIMD
void multiply_columns(std::size_t rows, std::size_t columns, const EntryRange* kept, const float* matrix,
                      const double* in_re, const double* in_im, double* out_re, double* out_im) {
    by_columns(rows, columns, kept, matrix, in_re, in_im, out_re, out_im);
}

}  // namespace contactd

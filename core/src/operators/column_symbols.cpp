#include "column_symbols.hpp"

#include <algorithm>

#include "wide.hpp"

namespace contactd {
namespace {

constexpr std::size_t lanes = Waves::lanes;

// Four wavenumbers side by side.
using Four [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

const Four& four(const double* values) {
    return *reinterpret_cast<const Four*>(values);
}
Four& four(double* values) {
    return *reinterpret_cast<Four*>(values);
}

void write_lanes(std::span<const double> transform, std::size_t step, double* to) {
    for (std::size_t at = 0; at < transform.size(); at += lanes, to += step) std::copy_n(&transform[at], lanes, to);
}

// Two rows at a time: what they take of the columns before them and what they give to those.
CONTACTD_WIDE
void multiply_symmetric(std::size_t n, const double* matrix, const double* in_re, const double* in_im, double* out_re,
                        double* out_im) {
    for (std::size_t row = 0; row < n * lanes; row += 2 * lanes) {
        const Four a_re = four(in_re + row), a_im = four(in_im + row);
        const Four b_re = four(in_re + row + lanes), b_im = four(in_im + row + lanes);
        Four to_a_re = {}, to_a_im = {}, to_b_re = {}, to_b_im = {};
        for (std::size_t column = 0; column < row; column += lanes, matrix += 2 * lanes) {
            const Four of_a = four(matrix), of_b = four(matrix + lanes);
            const Four re = four(in_re + column), im = four(in_im + column);
            to_a_re += of_a * re;
            to_a_im += of_a * im;
            to_b_re += of_b * re;
            to_b_im += of_b * im;
            four(out_re + column) += of_a * a_re + of_b * b_re;
            four(out_im + column) += of_a * a_im + of_b * b_im;
        }
        const Four aa = four(matrix), ab = four(matrix + lanes), bb = four(matrix + 2 * lanes);
        matrix += 3 * lanes;
        four(out_re + row) = to_a_re + aa * a_re + ab * b_re;
        four(out_im + row) = to_a_im + aa * a_im + ab * b_im;
        four(out_re + row + lanes) = to_b_re + ab * a_re + bb * b_re;
        four(out_im + row + lanes) = to_b_im + ab * a_im + bb * b_im;
    }
}

CONTACTD_WIDE
void multiply_rows(std::size_t rows, std::size_t columns, const double* matrix, const double* in_re,
                   const double* in_im, double* out_re, double* out_im) {
    for (std::size_t row = 0; row < rows * lanes; row += lanes) {
        Four re = {}, im = {};
        for (std::size_t column = 0; column < columns * lanes; column += lanes, matrix += lanes) {
            const Four value = four(matrix);
            re += value * four(in_re + column);
            im += value * four(in_im + column);
        }
        four(out_re + row) = re;
        four(out_im + row) = im;
    }
}

CONTACTD_WIDE
void multiply_columns(std::size_t rows, std::size_t columns, const double* matrix, const double* in_re,
                      const double* in_im, double* out_re, double* out_im) {
    std::fill_n(out_re, columns * lanes, 0.0);
    std::fill_n(out_im, columns * lanes, 0.0);
    for (std::size_t row = 0; row < rows * lanes; row += lanes) {
        const Four re = four(in_re + row), im = four(in_im + row);
        for (std::size_t column = 0; column < columns * lanes; column += lanes, matrix += lanes) {
            const Four value = four(matrix);
            four(out_re + column) += value * re;
            four(out_im + column) += value * im;
        }
    }
}

// Calls product(matrix, in_re, in_im, out_re, out_im) of each group.
template <class Product>
void for_groups(std::size_t groups, std::span<const double> values, const Waves& in, Waves& out,
                const Product& product) {
    const std::size_t matrix = values.size() / groups, from = in.entries * lanes, to = out.entries * lanes;
    for (std::size_t group = 0; group < groups; ++group)
        product(&values[group * matrix], &in.re[group * from], &in.im[group * from], &out.re[group * to],
                &out.im[group * to]);
}

}  // namespace

SymmetricSymbol::SymmetricSymbol(std::size_t groups, std::size_t entries)
    : groups_(groups), entries_(entries), values_(groups * entries * (entries + 1) / 2 * lanes) {}

void SymmetricSymbol::set(std::size_t row, std::size_t column, std::span<const double> transform) {
    const std::size_t a = std::max(row, column), b = std::min(row, column), first = a - a % 2;
    const std::size_t within = b < first ? 2 * b + a % 2 : 2 * first + a % 2 + b % 2;
    const std::size_t at = first * (first + 1) / 2 + within;
    write_lanes(transform, entries_ * (entries_ + 1) / 2 * lanes, &values_[at * lanes]);
}

void SymmetricSymbol::multiply(const Waves& in, Waves& out) const {
    for_groups(groups_, values_, in, out, [this](auto... arrays) { multiply_symmetric(entries_, arrays...); });
}

RectangularSymbol::RectangularSymbol(std::size_t groups, std::size_t rows, std::size_t columns)
    : groups_(groups), rows_(rows), columns_(columns), values_(groups * rows * columns * lanes) {}

void RectangularSymbol::set(std::size_t row, std::size_t column, std::span<const double> transform) {
    write_lanes(transform, rows_ * columns_ * lanes, &values_[(row * columns_ + column) * lanes]);
}

void RectangularSymbol::multiply(const Waves& in, Waves& out) const {
    for_groups(groups_, values_, in, out, [this](auto... arrays) { multiply_rows(rows_, columns_, arrays...); });
}

void RectangularSymbol::multiply_transposed(const Waves& in, Waves& out) const {
    for_groups(groups_, values_, in, out, [this](auto... arrays) { multiply_columns(rows_, columns_, arrays...); });
}

}  // namespace contactd

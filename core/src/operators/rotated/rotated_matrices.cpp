#include "rotated_matrices.hpp"

#include <cmath>

#include "types/simd.hpp"

namespace contactd {
namespace {

constexpr std::size_t lanes = Waves::lanes;

/// Holds the numbers of a group of wavenumbers by the distance in rows; sn and xn are null without coupling.
struct Group {
    const double *xx, *xs, *sum, *difference, *sn, *xn;

    Group(const MidwaySymbols& symbols, std::size_t group) {
        const std::size_t first = group * symbols.rows * lanes;
        const auto of = [&](const std::vector<double>& values) {
            return values.empty() ? nullptr : values.data() + first;
        };
        xx = of(symbols.xx);
        xs = of(symbols.xs);
        sum = of(symbols.sum);
        difference = of(symbols.difference);
        sn = of(symbols.sn);
        xn = of(symbols.xn);
    }
};

[[gnu::always_inline]] inline void store(const Four& value, double* to) {
    four(to) = value;
}
[[gnu::always_inline]] inline void store(const Four& value, float* to) {
    using FourFloats [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
    *reinterpret_cast<FourFloats*>(to) = __builtin_convertvector(value, FourFloats);
}

// Rotates for I >= J, where odd functions of the distance have a positive sign. Functions do not return vectors,
// because their ABI would depend on the instruction set.
[[gnu::always_inline]] inline void rotate(const Group& of, const PairRotations& by, std::size_t I, std::size_t J,
                                          Four& value) {
    const std::size_t at = (I - J) * lanes, pair = I * by.rows + J;
    value = by.cosine[pair] * four(of.sum + at);
    if (of.sn != nullptr) value += by.sine[pair] * four(of.sn + at);
}
template <class Number>
[[gnu::always_inline]] inline void put_normal(const Group& of, const PairRotations& by, std::size_t I, std::size_t J,
                                              Number* to) {
    Four rotated;
    rotate(of, by, I, J, rotated);
    store(rotated + four(of.difference + (I - J) * lanes), to);
}
template <class Number>
[[gnu::always_inline]] inline void put_across(const Group& of, const PairRotations& by, std::size_t I, std::size_t J,
                                              Number* to) {
    Four rotated;
    rotate(of, by, I, J, rotated);
    store(rotated - four(of.difference + (I - J) * lanes), to);
}
[[gnu::always_inline]] inline void mix(const Group& of, const PairRotations& by, std::size_t I, std::size_t J,
                                       Four& value) {
    const std::size_t at = (I - J) * lanes, pair = I * by.rows + J;
    value = by.cosine[pair] * four(of.xs + at);
    if (of.xn != nullptr) value += by.sine[pair] * four(of.xn + at);
}

template <class Number>
[[gnu::always_inline]] inline void normal(const Group& of, std::size_t rows, const PairRotations& whole,
                                          const std::size_t* begin, Number* matrix) {
    const std::size_t paired = rows - rows % 2;
    for (std::size_t I = 0; I < paired; I += 2, ++begin) {
        for (std::size_t J = *begin; J < I; ++J, matrix += 2 * lanes) {
            put_normal(of, whole, I, J, matrix);
            put_normal(of, whole, I + 1, J, matrix + lanes);
        }
        put_normal(of, whole, I, I, matrix);
        put_normal(of, whole, I + 1, I, matrix + lanes);
        put_normal(of, whole, I + 1, I + 1, matrix + 2 * lanes);
        matrix += 3 * lanes;
    }
    if (paired == rows) return;
    // An odd last row is paired with zeros, which are already there.
    for (std::size_t J = *begin; J <= paired; ++J, matrix += 2 * lanes) put_normal(of, whole, paired, J, matrix);
}

template <class Number>
[[gnu::always_inline]] inline void tangential(const Group& of, std::size_t rows, const PairRotations& whole,
                                              const PairRotations& half, const std::size_t* begin, Number* matrix) {
    for (std::size_t I = 0; I < rows; ++I, ++begin) {
        for (std::size_t J = *begin / 2; J < I; ++J, matrix += 4 * lanes) {
            Four sx;
            mix(of, half, I, J, sx);
            store(four(of.xx + (I - J) * lanes), matrix);
            store(sx, matrix + lanes);
            store(-sx, matrix + 2 * lanes);
            put_across(of, whole, I, J, matrix + 3 * lanes);
        }
        store(four(of.xx), matrix);
        store(four(of.xs), matrix + lanes);
        put_across(of, whole, I, I, matrix + 2 * lanes);
        matrix += 3 * lanes;
    }
}

template <class Number>
[[gnu::always_inline]] inline void coupling(const Group& of, std::size_t rows, const PairRotations& whole,
                                            const PairRotations& half, const EntryRange* kept, Number* matrix) {
    for (std::size_t I = 0; I < rows; ++I, ++kept)
        for (std::size_t J = kept->begin; J < kept->end; ++J, matrix += 2 * lanes) {
            const std::size_t at = (I > J ? I - J : J - I) * lanes, pair = I * rows + J;
            const double odd = I >= J ? 1 : -1;  // sign of odd functions of the distance, xs and sn
            // Waves of x, multiplied by -i, have the opposite sign here.
            Four xn = odd * half.sine[pair] * four(of.xs + at), sn = -whole.sine[pair] * four(of.sum + at);
            if (of.sn != nullptr) {
                xn -= half.cosine[pair] * four(of.xn + at);
                sn += odd * whole.cosine[pair] * four(of.sn + at);
            }
            store(xn, matrix);
            store(sn, matrix + lanes);
        }
}

}  // namespace

PairRotations::PairRotations(std::span<const double> angles, double factor)
    : rows(angles.size()), cosine(rows * rows), sine(rows * rows) {
    std::vector<double> c, s;
    for (const double angle : angles) {
        c.push_back(std::cos(factor * (angle - angles[0])));
        s.push_back(std::sin(factor * (angle - angles[0])));
    }
    for (std::size_t I = 0; I < rows; ++I)
        for (std::size_t J = 0; J < rows; ++J) {
            cosine[I * rows + J] = c[I] * c[J] + s[I] * s[J];
            sine[I * rows + J] = s[I] * c[J] - c[I] * s[J];
        }
}

CONTACTD_SIMD
void fill_normal(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole, const std::size_t* begin,
                 double* matrix) {
    normal(Group(symbols, group), symbols.rows, whole, begin, matrix);
}
CONTACTD_SIMD
void fill_normal(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole, const std::size_t* begin,
                 float* matrix) {
    normal(Group(symbols, group), symbols.rows, whole, begin, matrix);
}

CONTACTD_SIMD
void fill_tangential(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole,
                     const PairRotations& half, const std::size_t* begin, double* matrix) {
    tangential(Group(symbols, group), symbols.rows, whole, half, begin, matrix);
}
CONTACTD_SIMD
void fill_tangential(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole,
                     const PairRotations& half, const std::size_t* begin, float* matrix) {
    tangential(Group(symbols, group), symbols.rows, whole, half, begin, matrix);
}

CONTACTD_SIMD
void fill_coupling(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole,
                   const PairRotations& half, const EntryRange* kept, double* matrix) {
    coupling(Group(symbols, group), symbols.rows, whole, half, kept, matrix);
}
CONTACTD_SIMD
void fill_coupling(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole,
                   const PairRotations& half, const EntryRange* kept, float* matrix) {
    coupling(Group(symbols, group), symbols.rows, whole, half, kept, matrix);
}

}  // namespace contactd

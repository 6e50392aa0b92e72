// Defines numbers with their derivatives with respect to up to three inputs: forward differentiation.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "quad.hpp"
#include "types/simd.hpp"

namespace contactd {

// `Number` is double, or Quad for four of them side by side.
template <class Number>
struct DualOf {
    Number value{};
    std::array<Number, 3> by{};

    DualOf() = default;
    CONTACTD_INLINE DualOf(const Number& value_) : value(value_) {}
    /// Returns an input, whose derivative with respect to itself is 1.
    static DualOf input(const Number& value, std::size_t which) {
        DualOf result(value);
        result.by[which] = 1;
        return result;
    }

    /// Returns f(a) or f(a, b) with the given value and partial derivatives.
    CONTACTD_INLINE static DualOf of(const Number& value, const DualOf& a, const Number& by_a) {
        DualOf result(value);
        for (std::size_t i = 0; i < 3; ++i) result.by[i] = by_a * a.by[i];
        return result;
    }
    CONTACTD_INLINE static DualOf of(const Number& value, const DualOf& a, const Number& by_a, const DualOf& b,
                                     const Number& by_b) {
        DualOf result(value);
        for (std::size_t i = 0; i < 3; ++i) result.by[i] = by_a * a.by[i] + by_b * b.by[i];
        return result;
    }
    CONTACTD_INLINE DualOf& operator+=(const DualOf& b) { return *this = *this + b; }
    CONTACTD_INLINE DualOf& operator-=(const DualOf& b) { return *this = *this - b; }
    CONTACTD_INLINE DualOf operator-() const { return {-value, {-by[0], -by[1], -by[2]}}; }
    CONTACTD_INLINE friend DualOf operator+(const DualOf& a, const DualOf& b) {
        return {a.value + b.value, {a.by[0] + b.by[0], a.by[1] + b.by[1], a.by[2] + b.by[2]}};
    }
    CONTACTD_INLINE friend DualOf operator-(const DualOf& a, const DualOf& b) {
        return {a.value - b.value, {a.by[0] - b.by[0], a.by[1] - b.by[1], a.by[2] - b.by[2]}};
    }
    CONTACTD_INLINE friend DualOf operator*(const DualOf& a, const DualOf& b) {
        return of(a.value * b.value, a, b.value, b, a.value);
    }
    CONTACTD_INLINE friend DualOf operator/(const DualOf& a, const DualOf& b) {
        const Number ratio = a.value / b.value, inverse = 1 / b.value;
        return of(ratio, a, inverse, b, -ratio * inverse);
    }
    // Without these operators, constants would be multiplied as inputs are.
    CONTACTD_INLINE friend DualOf operator*(const Number& a, const DualOf& b) { return of(a * b.value, b, a); }
    CONTACTD_INLINE friend DualOf operator*(const DualOf& a, const Number& b) { return b * a; }
    CONTACTD_INLINE friend DualOf operator/(const DualOf& a, const Number& b) { return (1 / b) * a; }
    CONTACTD_INLINE friend auto operator>(const DualOf& a, const DualOf& b) { return a.value > b.value; }
    friend auto operator<=>(const DualOf& a, const DualOf& b) { return a.value <=> b.value; }
    friend bool operator==(const DualOf& a, const DualOf& b) { return a.value == b.value; }

   private:
    CONTACTD_INLINE DualOf(const Number& value_, const std::array<Number, 3>& by_) : value(value_), by(by_) {}
};

using Dual = DualOf<double>;

CONTACTD_INLINE DualOf<Quad> chosen(const Quad::Mask& first, const DualOf<Quad>& a, const DualOf<Quad>& b) {
    DualOf<Quad> result = chosen(first, a.value, b.value);
    for (std::size_t i = 0; i < 3; ++i) result.by[i] = chosen(first, a.by[i], b.by[i]);
    return result;
}

/// Returns four copies of a number, or the sum of four.
inline DualOf<Quad> each(const Dual& a) {
    DualOf<Quad> result(a.value);
    for (std::size_t i = 0; i < 3; ++i) result.by[i] = a.by[i];
    return result;
}
inline Dual sum_of(const DualOf<Quad>& a) {
    Dual result(sum_of(a.value));
    for (std::size_t i = 0; i < 3; ++i) result.by[i] = sum_of(a.by[i]);
    return result;
}

/// At zero, the square root has no derivative; it is set to zero.
template <class Number>
CONTACTD_INLINE DualOf<Number> sqrt(const DualOf<Number>& a) {
    using std::sqrt;
    const Number root = sqrt(a.value), none = 0, one = 1;
    const auto rises = root > none;
    return DualOf<Number>::of(root, a, chosen(rises, Number(0.5 / chosen(rises, root, one)), none));
}
template <class Number>
DualOf<Number> hypot(const DualOf<Number>& a, const DualOf<Number>& b) {
    return sqrt(a * a + b * b);
}
inline Dual atan(const Dual& a) {
    return Dual::of(std::atan(a.value), a, 1 / (1 + a.value * a.value));
}
inline Dual abs(const Dual& a) {
    return a.value < 0 ? -a : a;
}

}  // namespace contactd

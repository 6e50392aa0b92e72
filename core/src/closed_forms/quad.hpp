// Represents four numbers that are computed side by side, in one SIMD register if the processor has it, and choices
// between them, which each of the four makes as a single number would.
#pragma once

#include <cmath>

#include "types/simd.hpp"

namespace contactd {

struct Quad {
    Four value{};

    /// Holds which of the four satisfy a condition.
    struct Mask {
        decltype(Four{} > Four{}) value;

        CONTACTD_INLINE friend Mask operator&(const Mask& a, const Mask& b) { return {a.value & b.value}; }
        CONTACTD_INLINE friend Mask operator|(const Mask& a, const Mask& b) { return {a.value | b.value}; }
        CONTACTD_INLINE friend Mask operator^(const Mask& a, const Mask& b) { return {a.value ^ b.value}; }
    };

    Quad() = default;
    CONTACTD_INLINE Quad(double each) : value{each, each, each, each} {}
    CONTACTD_INLINE explicit Quad(const Four& values) : value(values) {}

    CONTACTD_INLINE Quad& operator+=(const Quad& b) { return value += b.value, *this; }
    CONTACTD_INLINE Quad operator-() const { return Quad(-value); }
    CONTACTD_INLINE friend Quad operator+(const Quad& a, const Quad& b) { return Quad(a.value + b.value); }
    CONTACTD_INLINE friend Quad operator-(const Quad& a, const Quad& b) { return Quad(a.value - b.value); }
    CONTACTD_INLINE friend Quad operator*(const Quad& a, const Quad& b) { return Quad(a.value * b.value); }
    CONTACTD_INLINE friend Quad operator/(const Quad& a, const Quad& b) { return Quad(a.value / b.value); }
    CONTACTD_INLINE friend Mask operator>(const Quad& a, const Quad& b) { return {a.value > b.value}; }
};

template <class Number>
CONTACTD_INLINE Number chosen(bool first, const Number& a, const Number& b) {
    return first ? a : b;
}
CONTACTD_INLINE bool any(bool holds) {
    return holds;
}

CONTACTD_INLINE double sum_of(const Quad& a) {
    return (a.value[0] + a.value[1]) + (a.value[2] + a.value[3]);
}
CONTACTD_INLINE Quad sqrt(const Quad& a) {
    return Quad(Four{std::sqrt(a.value[0]), std::sqrt(a.value[1]), std::sqrt(a.value[2]), std::sqrt(a.value[3])});
}

CONTACTD_INLINE Quad chosen(const Quad::Mask& first, const Quad& a, const Quad& b) {
    return Quad(first.value ? a.value : b.value);
}
CONTACTD_INLINE bool any(const Quad::Mask& holds) {
    return ((holds.value[0] | holds.value[1]) | (holds.value[2] | holds.value[3])) != 0;
}

}  // namespace contactd

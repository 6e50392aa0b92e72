// Numbers that know how they change with up to three inputs: forward differentiation.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "types/wide.hpp"

namespace contactd {

struct Dual {
    double value = 0;
    std::array<double, 3> by{};

    Dual() = default;
    Dual(double value_) : value(value_) {}
    /// An input itself.
    static Dual input(double value, std::size_t which) {
        Dual result(value);
        result.by[which] = 1;
        return result;
    }

    /// f(a, b) with the given value and partial derivatives.
    CONTACTD_INLINE static Dual of(double value, const Dual& a, double by_a, const Dual& b, double by_b) {
        Dual result(value);
        for (std::size_t i = 0; i < 3; ++i) result.by[i] = by_a * a.by[i] + by_b * b.by[i];
        return result;
    }
    CONTACTD_INLINE Dual& operator+=(const Dual& b) { return *this = of(value + b.value, *this, 1, b, 1); }
    CONTACTD_INLINE Dual& operator-=(const Dual& b) { return *this = of(value - b.value, *this, 1, b, -1); }
    CONTACTD_INLINE Dual& operator*=(const Dual& b) { return *this = of(value * b.value, *this, b.value, b, value); }
    CONTACTD_INLINE Dual& operator/=(const Dual& b) {
        const double ratio = value / b.value;
        return *this = of(ratio, *this, 1 / b.value, b, -ratio / b.value);
    }
    CONTACTD_INLINE Dual operator-() const { return of(-value, *this, -1, *this, 0); }
    CONTACTD_INLINE friend Dual operator+(Dual a, const Dual& b) { return a += b; }
    CONTACTD_INLINE friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
    CONTACTD_INLINE friend Dual operator*(Dual a, const Dual& b) { return a *= b; }
    CONTACTD_INLINE friend Dual operator/(Dual a, const Dual& b) { return a /= b; }
    friend auto operator<=>(const Dual& a, const Dual& b) { return a.value <=> b.value; }
    friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
};

/// At zero, where it has none, its derivative is taken as zero.
inline Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return Dual::of(root, a, root > 0 ? 0.5 / root : 0, a, 0);
}
inline Dual hypot(const Dual& a, const Dual& b) {
    return sqrt(a * a + b * b);
}
inline Dual abs(const Dual& a) {
    return a.value < 0 ? -a : a;
}

}  // namespace contactd

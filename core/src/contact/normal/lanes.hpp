// Loops over elements four at a time: one pass that updates arrays and sums several terms.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <type_traits>

namespace contactd {

using Lanes = Eigen::Array<double, 4, 1>;

/// T is double or Lanes.
template <class T>
T load(const double* values) {
    if constexpr (std::is_same_v<T, double>)
        return *values;
    else
        return Eigen::Map<const T>(values);
}

template <class T>
void store(const T& value, double* values) {
    if constexpr (std::is_same_v<T, double>)
        *values = value;
    else
        Eigen::Map<T>{values} = value;
}

inline double negative_part(double value) {
    return value < 0 ? value : 0;
}
inline Lanes negative_part(const Lanes& values) {
    return values.min(0.0);
}
inline double magnitude(double value) {
    return value < 0 ? -value : value;
}
inline Lanes magnitude(const Lanes& values) {
    return values.abs();
}

/// Sums of the terms over 0..n-1. `terms(T{}, i)` returns std::array<T, count> of element i, or of the four from i on.
template <std::size_t count, class Terms>
std::array<double, count> sums(std::size_t n, const Terms& terms) {
    std::array<Lanes, count> partial;
    for (Lanes& sum : partial) sum.setZero();
    std::size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        const std::array<Lanes, count> term = terms(Lanes{}, i);
        for (std::size_t k = 0; k < count; ++k) partial[k] += term[k];
    }
    std::array<double, count> result;
    for (std::size_t k = 0; k < count; ++k)
        result[k] = (partial[k][0] + partial[k][1]) + (partial[k][2] + partial[k][3]);
    for (; i < n; ++i) {
        const std::array<double, count> term = terms(double{}, i);
        for (std::size_t k = 0; k < count; ++k) result[k] += term[k];
    }
    return result;
}

}  // namespace contactd

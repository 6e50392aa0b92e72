// How large and how small numbers of a problem may be.
#pragma once

#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {

/// Largest magnitude in arrays: products of larger numbers leave the range of a double.
constexpr double largest_magnitude = 1e100;

/// For quotients and powers of such values, which otherwise leave the range of a double: curvatures, areas, tables.
inline void check_magnitude(double value, const std::string& field) {
    constexpr double smallest = 1e-30;
    if (std::abs(value) < smallest)
        throw InvalidArgument(field, "is " + number_text(value) + "; its magnitude must be at least 1e-30");
}

}  // namespace contactd

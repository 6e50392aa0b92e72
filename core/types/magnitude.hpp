// Limits the magnitude of the numbers of a problem.
#pragma once

#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {

/// Magnitudes in arrays are at most this, because products of larger numbers exceed the range of a double.
constexpr double largest_magnitude = 1e100;

/// Throws for a value whose quotients and powers, such as curvatures, areas and tables, would exceed the range of a
/// double.
inline void check_magnitude(double value, const std::string& field) {
    constexpr double smallest = 1e-30;
    if (std::abs(value) < smallest)
        throw InvalidArgument(field, "is " + number_text(value) + "; its magnitude must be at least 1e-30");
}

}  // namespace contactd

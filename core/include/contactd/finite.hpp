// Checks that numbers are within the range of a double.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "contactd/error.hpp"

namespace contactd {

/// A number of a table is infinite or NaN.
class NotFinite : public Error {
   public:
    using Error::Error;
};

inline bool all_finite(std::span<const double> values) {
    constexpr double largest = std::numeric_limits<double>::max();
    std::size_t finite = 0;  // The loop counts without an early exit, so that compilers vectorise it.
    for (const double value : values) finite += std::abs(value) <= largest;
    return finite == values.size();
}

}  // namespace contactd

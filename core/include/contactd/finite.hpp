// Numbers within the range of a double.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "contactd/error.hpp"

namespace contactd {

/// Returns the count of numbers that are infinite or NaN.
class NotFinite : public Error {
   public:
    using Error::Error;
};

inline bool all_finite(std::span<const double> values) {
    constexpr double largest = std::numeric_limits<double>::max();
    std::size_t finite = 0;  // counted without leaving the loop, so that compilers vectorise it
    for (const double value : values) finite += std::abs(value) <= largest;
    return finite == values.size();
}

}  // namespace contactd

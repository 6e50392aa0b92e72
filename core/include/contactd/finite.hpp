// Numbers within the range of a double.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "contactd/error.hpp"

namespace contactd {

/// Numbers that are beyond that range, or none.
class NotFinite : public Error {
   public:
    using Error::Error;
};

inline bool all_finite(std::span<const double> values) {
    constexpr double largest = std::numeric_limits<double>::max();
    std::size_t finite = 0;  // counted without leaving the loop, which compilers turn into one of vectors
    for (const double value : values) finite += std::abs(value) <= largest;
    return finite == values.size();
}

}  // namespace contactd

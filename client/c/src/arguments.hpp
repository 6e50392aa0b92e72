// What comes in: each throws InvalidArgument naming `field`.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "contactd.h"
#include "contactd/error.hpp"

namespace contactd::c {

template <class Pointee>
Pointee* given(Pointee* pointer, const char* field) {
    if (pointer == nullptr) throw InvalidArgument(field, "is NULL");
    return pointer;
}

inline double finite(double value, const char* field) {
    if (!std::isfinite(value)) throw InvalidArgument(field, "is not finite; it must be a number");
    return value;
}

/// One of the words 0..last.
inline std::int32_t word(std::int32_t value, std::int32_t last, const char* field) {
    if (value < 0 || value > last)
        throw InvalidArgument(field, "is " + std::to_string(value) +
                                         "; it must be one of the words of contactd.h, 0 to " + std::to_string(last));
    return value;
}

inline std::vector<double> array(const double* values, std::int32_t count, const char* field) {
    given(values, field);
    if (count < 1) throw InvalidArgument("count", "is " + std::to_string(count) + "; it must be at least 1");
    return {values, values + count};
}

}  // namespace contactd::c

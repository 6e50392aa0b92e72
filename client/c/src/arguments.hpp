// Checks arguments. All functions throw InvalidArgument naming `field`.
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

/// Returns whether a flag, 0 or 1, is set.
inline bool flag(std::int32_t value, const char* field) {
    if (value != 0 && value != 1) throw InvalidArgument(field, "is " + std::to_string(value) + "; it must be 0 or 1");
    return value == 1;
}

inline void at_least_zero(std::int32_t value, const char* field) {
    if (value < 0) throw InvalidArgument(field, "is " + std::to_string(value) + "; it must be at least 0");
}

inline std::vector<double> array(const double* values, std::int32_t count, const char* field) {
    given(values, field);
    if (count < 1) throw InvalidArgument("count", "is " + std::to_string(count) + "; it must be at least 1");
    return {values, values + count};
}

}  // namespace contactd::c

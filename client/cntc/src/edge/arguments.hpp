// Reads a caller's arguments, and refuses null pointers, numbers that are not finite, and arrays that are too short.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "given/checks.hpp"

namespace contactd::cntc {

using cases::positive;
using cases::whole;

inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();  ///< stands for a missing number

/// Throws Refused if the pointer is null.
void require(const void* pointer, const char* name);
int integer(const int* value, const char* name);
/// Throws Refused unless the number is finite.
double number(const double* value, const char* name);

/// Reads `count` finite numbers; at least `least` are required.
std::vector<double> numbers(const double* values, const int* count, int least, const char* name);
/// Reads a list of `size` numbers, and ignores the rest of the array.
std::vector<double> list(const double* values, const int* count, int size, const char* name);
std::span<const int> integers(const int* values, const int* count, int least, const char* name);

/// Returns an array to fill, with NaN in every element. Throws Refused if it has fewer than `least` elements.
std::span<double> room(double* values, const int* count, std::size_t least, const char* name);

/// Sets outputs to NaN, which remains if the call fails. A null pointer is ignored.
void clear(double* value);
void clear(double* values, const int* count);

}  // namespace contactd::cntc

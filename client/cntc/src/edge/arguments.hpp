// Reads what a caller passes, and refuses null pointers, numbers that are none, and arrays that are too short.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "given/checks.hpp"

namespace contactd::cntc {

using cases::positive;
using cases::whole;

inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();  ///< where a number does not exist

/// Throws Refused where the pointer is null.
void require(const void* pointer, const char* name);
int integer(const int* value, const char* name);
/// Finite.
double number(const double* value, const char* name);

/// `count` numbers, all of them finite; `least` of them are needed.
std::vector<double> numbers(const double* values, const int* count, int least, const char* name);
/// A list of `size` numbers; what an array holds beyond them is not read.
std::vector<double> list(const double* values, const int* count, int size, const char* name);
std::span<const int> integers(const int* values, const int* count, int least, const char* name);

/// An array to be filled, of which `least` numbers are needed. Whatever it is too short for is no number.
std::span<double> room(double* values, const int* count, std::size_t least, const char* name);

/// Sets outputs to NaN, which stays until there is a number; does nothing where the caller passes null.
void clear(double* value);
void clear(double* values, const int* count);

}  // namespace contactd::cntc

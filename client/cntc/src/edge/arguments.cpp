#include "arguments.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "edge/codes.hpp"
#include "edge/refused.hpp"
#include "types/number_text.hpp"

namespace contactd::cntc {
namespace {

int length_of(const int* count, const char* name) {
    require(count, "the length of an array");
    if (*count < 0)
        throw Refused(error_code::input, "The length of " + std::string(name) + " is " + std::to_string(*count) +
                                             "; it must be at least 0.");
    return *count;
}

void require_length(int count, std::size_t least, const char* name) {
    if (static_cast<std::size_t>(count) < least)
        throw Refused(error_code::input, std::string(name) + " has " + std::to_string(count) + " values, but " +
                                             std::to_string(least) + " are required.");
}

}  // namespace

void require(const void* pointer, const char* name) {
    if (pointer == nullptr) throw Refused(error_code::input, std::string(name) + " is a null pointer.");
}

int integer(const int* value, const char* name) {
    require(value, name);
    return *value;
}

double number(const double* value, const char* name) {
    require(value, name);
    if (!std::isfinite(*value))
        throw Refused(error_code::input, std::string(name) + " is " + number_text(*value) + "; it must be finite.");
    return *value;
}

std::vector<double> numbers(const double* values, const int* count, int least, const char* name) {
    require_length(length_of(count, name), static_cast<std::size_t>(least), name);
    return list(values, count, *count, name);
}

std::vector<double> list(const double* values, const int* count, int size, const char* name) {
    require_length(length_of(count, name), static_cast<std::size_t>(size), name);
    if (size > 0) require(values, name);
    for (int i = 0; i < size; ++i)
        if (!std::isfinite(values[i]))
            throw Refused(error_code::input,
                          std::string(name) + " contains " + number_text(values[i]) + "; its values must be finite.");
    return {values, values + size};
}

std::span<const int> integers(const int* values, const int* count, int least, const char* name) {
    const int n = length_of(count, name);
    require_length(n, static_cast<std::size_t>(least), name);
    if (n > 0) require(values, name);
    return {values, static_cast<std::size_t>(n)};
}

std::span<double> room(double* values, const int* count, std::size_t least, const char* name) {
    const int n = length_of(count, name);
    require(values, name);
    std::fill(values, values + n, nothing);
    require_length(n, least, name);
    return {values, static_cast<std::size_t>(n)};
}

void clear(double* value) {
    if (value != nullptr) *value = nothing;
}

void clear(double* values, const int* count) {
    if (values != nullptr && count != nullptr && *count > 0) std::fill(values, values + *count, nothing);
}

}  // namespace contactd::cntc

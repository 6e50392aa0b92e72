// Formats a number for an error message: the shortest text that reads back to it.
#pragma once

#include <charconv>
#include <string>

namespace contactd {

inline std::string number_text(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

/// Returns a measured or estimated number to three digits.
inline std::string short_text(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr;
    return {text, end};
}

/// Returns the number rounded to the twelve digits by which keys distinguish numbers.
inline double rounded(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 11).ptr;
    double result = value;
    std::from_chars(text, end, result);
    return result + 0.0;  // The sum removes a negative zero.
}

}  // namespace contactd

// A number as it stands in an error message: the shortest text that reads back to it.
#pragma once

#include <charconv>
#include <string>

namespace contactd {

inline std::string number_text(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

/// To three digits, for what was measured or estimated.
inline std::string short_text(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr;
    return {text, end};
}

/// To the twelve digits by which numbers of keys are told apart.
inline double rounded(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 11).ptr;
    double result = value;
    std::from_chars(text, end, result);
    return result + 0.0;  // no negative zero
}

}  // namespace contactd

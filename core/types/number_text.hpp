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

}  // namespace contactd

// Formats a number for a sentence: to four digits, without an exponent from 0.001 to a million.
#pragma once

#include <cmath>
#include <string>

#include "types/number_text.hpp"

namespace contactd {

inline std::string plain_text(double value) {
    if (value == 0 || !std::isfinite(value)) return number_text(value);
    const double digits = std::pow(10, 3 - std::floor(std::log10(std::abs(value))));
    const double shown = std::round(value * digits) / digits;
    const bool is_whole = std::abs(shown) < 1e6 && shown == std::round(shown);
    return is_whole ? std::to_string(std::lround(shown)) : number_text(shown);
}

}  // namespace contactd

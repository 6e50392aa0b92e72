// Formats coordinates for an error message.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

#include "contactd/section.hpp"

namespace contactd::geometry {

/// Returns "(y, z) = (1.5, -60)", to seven digits, without rounding errors.
inline std::string place_text(const SectionPoint& point) {
    const double least = 1e-10 * (std::abs(point.y) + std::abs(point.z));
    const auto digits = [&](double value) {
        char text[32];
        if (std::abs(value) <= least) value = 0;
        const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 7).ptr;
        return std::string(text, end);
    };
    return "(y, z) = (" + digits(point.y) + ", " + digits(point.z) + ")";
}

}  // namespace contactd::geometry

// Frames of columns along a circle.
#pragma once

#include <cmath>
#include <vector>

#include "contactd/section.hpp"

namespace contactd::test {

/// About the origin and its top; radius < 0: in a hollow, about its bottom.
inline std::vector<ColumnFrame> circle(double radius, int columns, double ds) {
    std::vector<ColumnFrame> frames;
    for (int i = 0; i < columns; ++i) {
        const double angle = (i - (columns - 1) / 2.0) * ds / radius;
        frames.push_back({radius * std::sin(angle), radius * std::cos(angle), angle});
    }
    return frames;
}

}  // namespace contactd::test

// Returns frames of strips along a circle.
#pragma once

#include <cmath>
#include <vector>

#include "contactd/section.hpp"

namespace contactd::test {

/// Places strips about the origin and its top; radius < 0: in a hollow, about its bottom.
inline std::vector<StripFrame> circle(double radius, int strips, double ds) {
    std::vector<StripFrame> frames;
    for (int i = 0; i < strips; ++i) {
        const double angle = (i - (strips - 1) / 2.0) * ds / radius;
        frames.push_back({radius * std::sin(angle), radius * std::cos(angle), angle});
    }
    return frames;
}

}  // namespace contactd::test

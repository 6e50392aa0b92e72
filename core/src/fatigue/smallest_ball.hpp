// The smallest ball around points of five dimensions, which deviators have.
#pragma once

#include <array>
#include <span>

namespace contactd {

using DeviatorPoint = std::array<double, 5>;

struct Ball {
    DeviatorPoint centre{};
    double radius = 0;
};

/// Returns the smallest ball around all points, one at least: its centre and radius to some 1e-9 of the radius.
Ball smallest_ball(std::span<const DeviatorPoint> points);

}  // namespace contactd

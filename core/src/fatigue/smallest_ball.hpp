// Computes the smallest ball around points of five dimensions, the dimension of deviators.
#pragma once

#include <array>
#include <span>

namespace contactd {

using DeviatorPoint = std::array<double, 5>;

struct Ball {
    DeviatorPoint centre{};
    double radius = 0;
};

/// Returns the smallest ball around all points, of which there is at least one. Its centre and radius are accurate to
/// about 1e-9 of the radius.
Ball smallest_ball(std::span<const DeviatorPoint> points);

}  // namespace contactd

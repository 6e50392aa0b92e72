// Defines the frame of a rolling elliptic contact: x is along the rolling direction, so that the leading edge is at
// positive x.
#pragma once

#include <cmath>

#include "contactd/error.hpp"
#include "contactd/friction.hpp"
#include "contactd/gap.hpp"

namespace contactd {

struct RollingFrame {
    double c = 1, s = 0;  ///< cosine and sine of the rolling direction
    SemiAxes axes;        ///< a along the rolling direction

    double along(double x, double y) const { return c * x + s * y; }
    double across(double x, double y) const { return c * y - s * x; }
    double x_of(double along, double across) const { return c * along - s * across; }
    double y_of(double along, double across) const { return s * along + c * across; }
};

/// Returns the frame. Throws InvalidArgument ("friction.rolling.chi") if the rolling direction is not an axis of the
/// ellipse.
inline RollingFrame rolling_frame(const SemiAxes& axes, double chi) {
    constexpr double tolerance = 1e-9;
    const double c = std::cos(chi), s = std::sin(chi);
    if (std::abs(s) <= tolerance) return {std::copysign(1.0, c), 0, axes};
    if (std::abs(c) <= tolerance) return {0, std::copysign(1.0, s), {axes.b, axes.a}};
    if (std::abs(axes.a - axes.b) <= tolerance * axes.a) return {c, s, axes};
    throw InvalidArgument("friction.rolling.chi",
                          "is " + std::to_string(chi) +
                              " rad, which is not along an axis of the contact ellipse; simplified models support "
                              "multiples of pi/2, and any direction for a circle: use one of them, or model full");
}

}  // namespace contactd

// Defines the functions at a corner of a loaded rectangle from which the fields below it are computed.
#pragma once

#include <algorithm>
#include <cmath>

namespace contactd {

/// Describes a point at (x, y) from the corner, at the depth d >= 0 below it. Distances below `smallest` count as
/// `smallest` where a field is infinite.
struct PatchCorner {
    double x, y, d, smallest, rho;

    PatchCorner(double x_, double y_, double d_, double smallest_) : x(x_), y(y_), d(d_), smallest(smallest_) {
        rho = std::max(std::sqrt(x * x + y * y + d * d), smallest);
    }
    // (x^2 + d^2)/(rho - y) avoids cancellation for negative y.
    double sum(double along, double across) const {  // rho + along
        const double square = std::max(across * across + d * d, smallest * smallest);
        return along < 0 ? square / (rho - along) : std::max(rho + along, smallest);
    }
    double rho_and_x() const { return sum(x, y); }
    double rho_and_y() const { return sum(y, x); }
    double solid_angle() const { return std::atan2(x * y, d * rho); }
    double angle_xx() const { return std::atan2(x * y * (x * x + y * y), (rho + d) * (x * x * rho + d * y * y)); }
};

}  // namespace contactd

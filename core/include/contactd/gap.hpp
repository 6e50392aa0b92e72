// Defines the undeformed distance between the two bodies, in the forms that a request accepts.
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

/// Describes h = x^2/(2 Rx) + y^2/(2 Ry) (mm). A direction is flat if its radius is infinite, concave if it is
/// negative.
struct Paraboloid {
    double Rx = std::numeric_limits<double>::infinity();
    double Ry = std::numeric_limits<double>::infinity();

    bool operator==(const Paraboloid&) const = default;
};

/// Describes the paraboloid whose Hertzian contact has these semi-axes (mm) under the approach or force of the problem.
struct SemiAxes {
    double a = 0;  ///< along x
    double b = 0;  ///< along y

    bool operator==(const SemiAxes&) const = default;
};

/// Describes two half ellipses with prescribed pressures (mm), which join at y = (b_negative - b_positive)/2
/// (Piotrowski, Liu, Bruni 2017: SDEC). The corresponding surfaces are not computed.
struct HalfEllipses {
    double a = 0;           ///< along x
    double b_negative = 0;  ///< across, towards -y
    double b_positive = 0;  ///< across, towards +y

    SemiAxes mean() const { return {a, (b_negative + b_positive) / 2}; }
    double joint() const { return (b_negative - b_positive) / 2; }
    bool operator==(const HalfEllipses&) const = default;
};

/// Describes the gap without the approach. An array contains h of each element, shape [ny, nx] (mm).
using Gap = std::variant<Paraboloid, SemiAxes, std::vector<double>, HalfEllipses>;

/// Returns h at the element centres, shape [ny, nx] (mm).
std::vector<double> sampled(const Paraboloid& paraboloid, const Grid& grid);

}  // namespace contactd

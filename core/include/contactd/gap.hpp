// The undeformed distance between the two bodies: how a request may give it.
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

/// h = x^2/(2 Rx) + y^2/(2 Ry) (mm); an infinite radius is a flat direction, a negative one concave.
struct Paraboloid {
    double Rx = std::numeric_limits<double>::infinity();
    double Ry = std::numeric_limits<double>::infinity();

    bool operator==(const Paraboloid&) const = default;
};

/// The paraboloid whose Hertzian contact has these semi-axes (mm) under the approach or force of the problem.
struct SemiAxes {
    double a = 0;  ///< along x
    double b = 0;  ///< along y

    bool operator==(const SemiAxes&) const = default;
};

/// Two half ellipses that pressures are prescribed over (mm), which join at y = (b_negative - b_positive)/2
/// (Piotrowski, Liu, Bruni 2017: SDEC). The surfaces that touch so are not known.
struct HalfEllipses {
    double a = 0;           ///< along x
    double b_negative = 0;  ///< across, towards -y
    double b_positive = 0;  ///< across, towards +y

    SemiAxes mean() const { return {a, (b_negative + b_positive) / 2}; }
    double joint() const { return (b_negative - b_positive) / 2; }
    bool operator==(const HalfEllipses&) const = default;
};

/// An array holds h per element, shape [ny, nx] (mm). Without the approach in all of them.
using Gap = std::variant<Paraboloid, SemiAxes, std::vector<double>, HalfEllipses>;

/// h at the element centres, shape [ny, nx] (mm).
std::vector<double> sampled(const Paraboloid& paraboloid, const Grid& grid);

}  // namespace contactd

#include "geometry/search/equivalent_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contactd::geometry {
namespace {

constexpr double most_slender = 16;  // ratio of semi-axes: the quick models know contacts of up to 32

}  // namespace

// A row that is d deep overlaps as d - a x^2: its volume is 4/3 d^1.5/sqrt(a), the mean of x^2 over it d/(5 a). That of
// an ellipse's paraboloid is a sixth of the square of its semi-axis, and its volume half of approach times area.
EquivalentEllipse equivalent_ellipse(const Locus& locus, double z, const RegionGroup& group) {
    const double a = locus.curvature(), middle = group.reference.y;
    double volume = 0, along = 0, first = 0, second = 0;
    for (const LocusRow& row : locus.rows()) {
        if (row.y < group.y.from || row.y > group.y.to || !(row.gap < z)) continue;
        const double depth = z - row.gap, weight = depth * std::sqrt(depth), y = row.y - middle;
        volume += weight;
        along += weight * depth;
        first += weight * y;
        second += weight * y * y;
    }
    const double cosine = std::abs(std::cos(group.reference.angle)), mean = first / volume;
    // A row is as wide as the step, which matters where there is but one.
    const double variance = second / volume - mean * mean + locus.step() * locus.step() / 12;
    EquivalentEllipse ellipse;
    ellipse.along = std::sqrt(6.0 / 5 * along / volume / a);
    const double across = std::sqrt(6 * variance) / cosine;
    ellipse.across = std::clamp(across, ellipse.along / most_slender, ellipse.along * most_slender);
    ellipse.approach =
        2 * volume * locus.step() * 4.0 / 3 / std::sqrt(a) / (std::numbers::pi * ellipse.along * ellipse.across);
    return ellipse;
}

}  // namespace contactd::geometry

#include "geometry/placement/shape_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::geometry {
namespace {

constexpr double around_top = 1.5;  // slopes over those of parabolas, beside an extremum
constexpr double most_bent = 2;     // second derivatives over the largest second difference around

double minmod(double a, double b) {
    return a * b > 0 ? std::copysign(std::min(std::abs(a), std::abs(b)), a) : 0;
}

}  // namespace

double ShapeBounds::chord(std::ptrdiff_t piece) const {
    const double rise = values_[knots_.wrapped(piece + 1)] - values_[knots_.wrapped(piece)];
    return std::abs(rise) <= same_value ? 0 : rise / knots_.width(piece);
}

double ShapeBounds::bend(std::ptrdiff_t knot) const {
    if (!knots_.exists(knot - 1) || !knots_.exists(knot)) return 0;
    return (chord(knot) - chord(knot - 1)) / (knots_.place(knot + 1) - knots_.place(knot - 1));
}

double ShapeBounds::smoothness(std::ptrdiff_t knot) const {
    const double before = bend(knot - 1), here = bend(knot), behind = bend(knot + 1);
    const double least = std::abs(minmod(minmod(before, here), behind));
    const double largest = std::max({std::abs(before), std::abs(here), std::abs(behind)});
    return largest > 0 ? std::clamp(4 * least / largest - 1, 0.0, 1.0) : 0;
}

double ShapeBounds::largest_slope(std::size_t knot) const {
    const auto i = static_cast<std::ptrdiff_t>(knot);
    const bool first = !knots_.exists(i - 1), last = !knots_.exists(i);
    const double before = first ? chord(i) : chord(i - 1), behind = last ? chord(i - 1) : chord(i);
    const double lesser = minmod(before, behind);
    const double left = first ? behind : before + minmod(bend(i - 1), bend(i)) * knots_.width(i - 1);
    const double right = last ? before : behind - minmod(bend(i), bend(i + 1)) * knots_.width(i);
    // The parabola of a narrow piece does not indicate an extremum far away, within a wide piece.
    const double support = std::min(first ? 1 : knots_.support(i - 1), last ? 1 : knots_.support(i));
    const double top = support * minmod(left, right);
    const double limit = std::copysign(std::max(steepest_slope * std::abs(lesser), around_top * std::abs(top)),
                                       lesser != 0 ? lesser : top);
    // Beside an extremum, both parabolas may have slopes of either sign; the true one is between.
    const double weight = lesser == 0 ? support * smoothness(i) : 0;
    return std::max({0.0, limit, weight * around_top * std::max(left, right)});
}

double ShapeBounds::largest_curving(std::size_t knot) const {
    const auto i = static_cast<std::ptrdiff_t>(knot);
    const bool first = !knots_.exists(i - 1), last = !knots_.exists(i);
    const double largest = std::max({std::abs(bend(i - 1)), std::abs(bend(i)), std::abs(bend(i + 1))});
    const double bent = first ? bend(i + 1) : last ? bend(i - 1) : bend(i);
    return bent > 0 ? 2 * most_bent * largest : 0;
}

bool ShapeBounds::is_top(std::ptrdiff_t piece) const {
    const double sign = bend(piece);
    return knots_.support(piece) == 1 && bend(piece - 1) * sign > 0 && bend(piece + 1) * sign > 0 &&
           bend(piece + 2) * sign > 0;
}

}  // namespace contactd::geometry

// Finds parts of a profile over which a direction ascends, which are visible at a right angle to it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "contactd/profile.hpp"

namespace contactd::geometry {

/// Holds parameters of a curve, and the ascending values at both.
struct Span {
    double from = 0, to = 0;
    double low = 0, high = 0;
};

/// Returns the span from the knot nearest to s to both sides, as long as `value` of the points ascends.
template <class Value>
Span ascending_span(const ProfileCurve& curve, double s, const Value& value) {
    const std::vector<double>& knots = curve.knots();
    const std::vector<ProfilePoint>& points = curve.points();
    const auto behind = std::lower_bound(knots.begin(), knots.end(), s);
    std::size_t start = behind == knots.end() ? knots.size() - 1 : static_cast<std::size_t>(behind - knots.begin());
    if (start > 0 && s - knots[start - 1] < knots[start] - s) --start;
    std::size_t first = start, last = start;
    while (first > 0 && value(points[first - 1]) < value(points[first])) --first;
    while (last + 1 < points.size() && value(points[last + 1]) > value(points[last])) ++last;
    return {knots[first], knots[last], value(points[first]), value(points[last])};
}

/// Returns the span that is visible from above, from the point in the middle to both sides. y of the curve ascends from
/// its first point to its last; `rotated_y` returns y in the track.
template <class RotatedY>
Span visible_span(const ProfileCurve& curve, const RotatedY& rotated_y) {
    const double middle = 0.5 * (curve.points().front().y + curve.points().back().y);
    return ascending_span(curve, curve.s_at_y(middle), rotated_y);
}

}  // namespace contactd::geometry

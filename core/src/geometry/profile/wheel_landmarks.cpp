#include "geometry/profile/wheel_landmarks.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::geometry {
namespace {

constexpr double least_flange = 10;         // mm: least height of the tip over the tread
constexpr double least_hollow = 0.02;       // 1/mm: throats have radii of 13 to 20 mm, and worn ones of 30
constexpr double to_tread = 55;             // mm from the tip to the running circle, 70 mm from the flange's back
constexpr double step = 0.25, reach = 1.5;  // mm along the curve, and to both sides for a curvature without noise

ProfilePoint difference(const ProfilePoint& a, const ProfilePoint& b) {
    return {a.y - b.y, a.z - b.z};
}

/// Returns the curvature of the circle through three points of the curve (1/mm): positive in a hollow of the wheel.
double hollowness(const ProfileCurve& curve, double s) {
    const ProfilePoint here = curve.at(s), before = difference(here, curve.at(s - reach)),
                       behind = difference(curve.at(s + reach), here), across{before.y + behind.y, before.z + behind.z};
    const double twice_area = before.y * behind.z - before.z * behind.y;
    return 2 * twice_area /
           (std::hypot(before.y, before.z) * std::hypot(behind.y, behind.z) * std::hypot(across.y, across.z));
}

}  // namespace

std::optional<WheelLandmarks> wheel_landmarks(const ProfileCurve& wheel) {
    const auto tip = std::ranges::max_element(wheel.points(), {}, &ProfilePoint::z);
    const double y_of_tread = std::min(tip->y + to_tread, wheel.points().back().y);
    const double from = wheel.knots()[static_cast<std::size_t>(tip - wheel.points().begin())],
                 to = wheel.s_at_y(y_of_tread);
    WheelLandmarks found{*tip, *tip, wheel.at(to)};
    if (!(found.tip.z - found.tread.z >= least_flange)) return {};
    double hollowest = least_hollow;
    for (double s = from + reach; s < to - reach; s += step) {
        const double here = hollowness(wheel, s);
        if (here <= hollowest) continue;
        hollowest = here;
        found.throat = wheel.at(s);
    }
    if (found.throat == found.tip) return {};
    return found;
}

}  // namespace contactd::geometry

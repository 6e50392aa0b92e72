#include "geometry/profile/gauge_side.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace contactd::geometry {
namespace {

constexpr double of_top = 0.2;       // mm below the highest point, a level that noise affects little
constexpr double of_head = 10;       // mm below the top, where corners have ended and side wear has not begun
constexpr double least_of_head = 2;  // mm
// Heads of radius 200 mm with an inclination of 1/40 have 3.6 mm, those of 300 mm 5.4 mm.
constexpr double clearly = 2.5;
constexpr double of_gauge = 14;          // mm below the top, where gauges are measured
constexpr double of_rolled_surface = 8;  // mm: a side that ends higher was not measured

/// Returns y where the head passes a level on one side of its top, or its end if rounding errors put the level below
/// it.
double y_at(const std::vector<ProfilePoint>& points, std::size_t top, double level, bool right) {
    for (std::size_t i = top;;) {
        const std::size_t next = right ? i + 1 : i - 1;
        if (next >= points.size()) return points[i].y;
        if (points[next].z >= level) {
            const double share = (level - points[i].z) / (points[next].z - points[i].z);
            return points[i].y + share * (points[next].y - points[i].y);
        }
        i = next;
    }
}

/// Returns whether the profile falls monotonically from its top to a level; noses with wings do not.
bool falls(const std::vector<ProfilePoint>& points, std::size_t top, double level, bool right) {
    constexpr double waves = 0.1;  // mm
    double lowest = points[top].z;
    for (std::size_t i = top; lowest < level && (right ? i + 1 < points.size() : i > 0);) {
        i = right ? i + 1 : i - 1;
        if (points[i].z < lowest - waves) return false;
        lowest = std::max(lowest, points[i].z);
    }
    return true;
}

struct Head {
    std::size_t top;
    double left, right;  // visible depth below the top on each side (mm)
};

Head head_of(const std::vector<ProfilePoint>& points) {
    const auto highest = std::ranges::min_element(points, {}, &ProfilePoint::z);
    const auto depth = [&](auto from, auto to) {
        return std::ranges::max_element(from, to, {}, &ProfilePoint::z)->z - highest->z;
    };
    return {static_cast<std::size_t>(highest - points.begin()), depth(points.begin(), highest + 1),
            depth(highest, points.end())};
}

}  // namespace

std::optional<double> top_beside_middle(const ProfileCurve& rail) {
    const auto& points = rail.points();
    const Head head = head_of(points);
    const double depth = std::min({of_head, head.left, head.right});
    if (depth < least_of_head) return std::nullopt;
    const double z = points[head.top].z;
    for (const bool right : {false, true})
        if (!falls(points, head.top, z + depth, right)) return std::nullopt;
    const auto middle = [&](double level) {
        return 0.5 * (y_at(points, head.top, z + level, false) + y_at(points, head.top, z + level, true));
    };
    return middle(of_top) - middle(depth);
}

bool has_gauge_side_at_right(const ProfileCurve& rail) {
    const Head head = head_of(rail.points());
    const auto is_only = [](double one, double other) { return one >= of_gauge && other < of_rolled_surface; };
    if (is_only(head.right, head.left)) return true;
    if (is_only(head.left, head.right)) return false;
    const std::optional<double> beside = top_beside_middle(rail);
    return beside && *beside < -clearly;
}

}  // namespace contactd::geometry

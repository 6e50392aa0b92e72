#include "geometry/profile/exchanged_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace contactd::geometry {
namespace {

constexpr double flange_rise = 10, widest_flange = 45, least_tread = 60;  // mm: height, widths
constexpr double head_depth = 14, narrowest_head = 50;                    // mm: depth, width
constexpr double steep_side = 3;                                          // dz/dy of the sides of a head

/// Holds the points of a profile beyond which it is farther than a distance from its extreme point.
struct Peak {
    std::size_t left, right;
};

/// `is_upwards` selects the point with the least z, otherwise that with the largest. Returns nothing if a side is too
/// short.
std::optional<Peak> peak_of(std::span<const ProfilePoint> points, double distance, bool is_upwards) {
    const auto [least, largest] = std::ranges::minmax_element(points, {}, &ProfilePoint::z);
    const auto extreme = is_upwards ? least : largest;
    const auto is_far = [&](const ProfilePoint& point) { return std::abs(point.z - extreme->z) >= distance; };
    const auto right = std::find_if(extreme, points.end(), is_far);
    auto left = extreme;
    while (left != points.begin() && !is_far(*left)) --left;
    if (right == points.end() || !is_far(*left)) return {};
    return Peak{static_cast<std::size_t>(left - points.begin()), static_cast<std::size_t>(right - points.begin())};
}

bool is_steep(const ProfilePoint& one, const ProfilePoint& other) {
    return std::abs(other.z - one.z) > steep_side * std::abs(other.y - one.y);
}

}  // namespace

bool has_shape_of_wheel(const ProfileCurve& rail) {
    const auto& points = rail.points();
    const auto flange = peak_of(points, flange_rise, true);
    return flange && points[flange->right].y - points[flange->left].y < widest_flange &&
           points.back().y - points[flange->right].y > least_tread;
}

bool has_shape_of_rail(const ProfileCurve& wheel) {
    const auto& points = wheel.points();
    const auto head = peak_of(points, head_depth, false);
    return head && points[head->right].y - points[head->left].y > narrowest_head &&
           is_steep(points[head->left], points[head->left + 1]) &&
           is_steep(points[head->right - 1], points[head->right]);
}

}  // namespace contactd::geometry

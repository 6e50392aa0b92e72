// The rules are those of the CONTACT program for files that do not say which way z points (MIRRORZ = 0), which always
// decides; here small flanges, and ends that say different things, leave it open.
#include "points_upwards.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ranges>

namespace contactd::geometry {
namespace {

using Points = std::vector<ProfilePoint>;

constexpr double at_an_end = 0.1;    // part of a rail's points
constexpr double noticed = 1e-3;     // part of its height
constexpr double face = 0.05;        // part of a wheel's width: the edges of its faces
constexpr double least_flange = 10;  // mm that a flange stands out at least

/// Whether what is next to one end of a rail has a larger z, or a smaller one.
template <class Iterator>
std::optional<bool> rises_inwards(Iterator first, std::size_t count, double height) {
    const auto inside = std::find_if(first, first + static_cast<std::ptrdiff_t>(count), [&](const ProfilePoint& point) {
        return std::abs(point.z - first->z) > noticed * height;
    });
    if (inside == first + static_cast<std::ptrdiff_t>(count)) return {};
    return inside->z > first->z;
}

std::optional<bool> rail_upwards(const Points& points, double height) {
    const auto count =
        std::max<std::size_t>(2, static_cast<std::size_t>(at_an_end * static_cast<double>(points.size())));
    const auto first = rises_inwards(points.begin(), count, height),
               last = rises_inwards(points.rbegin(), count, height);
    if (first && last && *first != *last) return {};
    return first ? first : last;
}

std::optional<bool> wheel_upwards(const Points& points, double height) {
    if (height < least_flange) return {};
    const auto [left, right] = std::ranges::minmax(points | std::views::transform(&ProfilePoint::y));
    const auto [least, most] = std::ranges::minmax_element(points, {}, &ProfilePoint::z);
    const auto lies_on_a_face = [&, left = left, right = right](const ProfilePoint& point) {
        return std::min(point.y - left, right - point.y) < face * (right - left);
    };
    const bool least_on_face = lies_on_a_face(*least), most_on_face = lies_on_a_face(*most);
    if (least_on_face != most_on_face) return most_on_face;  // what is in the middle is the flange's tip
    // Both or none of them: the tread lies nearer to one of the extremes, and the tip is the other one.
    std::vector<double> heights;
    for (const ProfilePoint& point : points) heights.push_back(point.z);
    const auto median = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, median);
    const double above = *median - least->z, below = most->z - *median;
    if (std::abs(above - below) < 0.2 * height) return {};
    return above > below;
}

}  // namespace

std::optional<bool> points_upwards(const Points& points, ProfileKind kind) {
    if (points.size() < 3) return {};
    const auto [least, most] = std::ranges::minmax_element(points, {}, &ProfilePoint::z);
    const double height = most->z - least->z;
    if (!(height > 0)) return {};
    return kind == ProfileKind::wheel ? wheel_upwards(points, height) : rail_upwards(points, height);
}

}  // namespace contactd::geometry

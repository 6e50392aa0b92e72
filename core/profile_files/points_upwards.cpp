// Uses the CONTACT program's rule for rails if a file does not define the direction of z (MIRRORZ = 0). CONTACT's rule
// for wheels would turn a wheel that was measured from the tip of its flange upside down, so this one is different.
#include "points_upwards.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <ranges>

namespace contactd::geometry {
namespace {

using Points = std::vector<ProfilePoint>;

constexpr double at_an_end = 0.1;    // part of a rail's points
constexpr double noticed = 1e-3;     // part of its height
constexpr double face = 0.05;        // part of a wheel's width at each end
constexpr double least_flange = 10;  // mm: smallest height of a flange
constexpr double clearly = 1.5;      // factor by which it must exceed the other side

/// Returns whether the points next to one end of a rail have a larger z, or a smaller one.
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

/// A flange stands out from the tread more than any other part, except the wheel's faces, which are upright at its ends
/// and are omitted. A profile with the same depth at both ends is a disc, or has two flanges.
std::optional<Flange> flange_among(const Points& points) {
    const auto [left, right] = std::ranges::minmax(points | std::views::transform(&ProfilePoint::y));
    const double edge = face * (right - left);
    std::vector<ProfilePoint> inner;
    std::ranges::copy_if(points, std::back_inserter(inner), [&, left = left, right = right](const ProfilePoint& point) {
        return point.y >= left + edge && point.y <= right - edge;
    });
    if (inner.size() < 3) return {};
    std::vector<double> heights;
    for (const ProfilePoint& point : inner) heights.push_back(point.z);
    const auto median = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, median);
    const double tread = *median, above = tread - std::ranges::min(heights), below = std::ranges::max(heights) - tread;
    const double flange = std::max(above, below);
    if (flange < least_flange || flange < clearly * std::min(above, below)) return {};
    const bool is_upwards = above > below;
    const auto [first, last] = std::ranges::minmax_element(inner, {}, &ProfilePoint::y);
    const auto is_deep = [&](const ProfilePoint& end) {
        return (is_upwards ? tread - end.z : end.z - tread) > 0.5 * flange;
    };
    if (is_deep(*first) && is_deep(*last)) return {};
    const auto [highest, lowest] = std::ranges::minmax_element(inner, {}, &ProfilePoint::z);
    return Flange{is_upwards, (is_upwards ? highest : lowest)->y < (left + right) / 2};
}

}  // namespace

std::optional<bool> points_upwards(const Points& points, ProfileKind kind) {
    if (points.size() < 3) return {};
    const auto [least, most] = std::ranges::minmax_element(points, {}, &ProfilePoint::z);
    const double height = most->z - least->z;
    if (!(height > 0)) return {};
    if (kind == ProfileKind::rail) return rail_upwards(points, height);
    const std::optional<Flange> flange = flange_among(points);
    return flange ? std::optional(flange->upwards) : std::nullopt;
}

std::optional<Flange> flange_of(const Points& points) {
    return points.size() < 3 ? std::nullopt : flange_among(points);
}

double rounding_of(const Points& points) {
    for (const double step : {1.0, 0.1, 0.01, 0.001}) {
        const auto is_rounded = [step](double value) {
            return std::abs(value / step - std::round(value / step)) < 1e-6;
        };
        if (std::ranges::all_of(points, [&](const ProfilePoint& p) { return is_rounded(p.y) && is_rounded(p.z); }))
            return step;
    }
    return 0;
}

}  // namespace contactd::geometry

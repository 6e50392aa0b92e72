#include "geometry/search/regions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace contactd::geometry {
namespace {

/// Changes the angle of upright planes, which have no z for their y.
double away_from_upright(double angle) {
    constexpr double upright = std::numbers::pi / 2, least = 1e-3;
    if (std::abs(std::abs(angle) - upright) >= least) return angle;
    return std::copysign(std::abs(angle) < upright ? upright - least : upright + least, angle);
}

double between(const Extent& a, const Extent& b) {
    return std::max({0.0, a.from - b.to, b.from - a.to});
}

/// Returns the distance between two objects with extents.
template <class A, class B>
double distance(const A& a, const B& b) {
    const double x = between(a.x, b.x), y = between(a.y, b.y);
    double z = 0;
    if (y > 0) z = a.y.from > b.y.to ? a.z.from - b.z.to : b.z.from - a.z.to;
    return std::sqrt(x * x + y * y + z * z);
}

Extent both(const Extent& a, const Extent& b) {
    return {std::min(a.from, b.from), std::max(a.to, b.to)};
}

ContactReference mean_of(const ContactReference& a, double a_size, const ContactReference& b, double b_size) {
    const double share = b_size / (a_size + b_size);
    const auto mean = [&](double of_a, double of_b) { return of_a + share * (of_b - of_a); };
    return {mean(a.x, b.x), mean(a.y, b.y), 0, mean(a.angle, b.angle)};
}

/// Unites a group with `left`, which lies to the left of all its parts.
RegionGroup united(const RegionGroup& group, const RegionGroup& left) {
    RegionGroup result = group;
    result.reference = mean_of(group.reference, group.size, left.reference, left.size);
    result.z = {left.y.from < group.y.from ? left.z.from : group.z.from,
                left.y.to > group.y.to ? left.z.to : group.z.to};
    result.x = both(group.x, left.x);
    result.y = both(group.y, left.y);
    result.size += left.size;
    result.regions.insert(result.regions.end(), left.regions.begin(), left.regions.end());
    return result;
}

/// Joins neighbours that are at most `farthest` apart.
std::vector<RegionGroup> joined(const std::vector<RegionGroup>& parts, double farthest, double angle_separate) {
    std::vector<RegionGroup> groups;
    for (const RegionGroup& part : parts) {
        if (!groups.empty() && distance(groups.back(), part) <= farthest &&
            std::abs(groups.back().reference.angle - part.reference.angle) <= angle_separate)
            groups.back() = united(groups.back(), part);
        else
            groups.push_back(part);
    }
    return groups;
}

/// Returns the group as one region.
OverlapRegion merged(const RegionGroup& group) {
    OverlapRegion region{group.reference, group.x, group.y, group.z, 0, group.size};
    for (const OverlapRegion& part : group.regions) region.penetration = std::max(region.penetration, part.penetration);
    return region;
}

std::vector<double> shares_of(const std::vector<OverlapRegion>& regions, const PatchRules& rules) {
    constexpr double exponent = 0.8;
    std::vector<double> shares;
    for (const OverlapRegion& j : regions)
        for (const OverlapRegion& k : regions) {
            const double free =
                (rules.distance_separate - distance(j, k)) / (rules.distance_separate - rules.distance_combine);
            shares.push_back(&j == &k ? 1 : std::pow(std::clamp(free, 0.0, 1.0), exponent));
        }
    return shares;
}

// Rotates planes of patches that approach each other, so that they agree when the patches merge.
void turn_neighbours(std::vector<RegionGroup>& groups, const PatchRules& rules) {
    const std::vector<RegionGroup> before = groups;
    for (std::size_t i = 0; i + 1 < groups.size(); ++i) {
        const RegionGroup &right = before[i], &left = before[i + 1];
        const double apart = distance(right, left);
        if (apart < rules.distance_separate || apart > rules.distance_turn ||
            std::abs(right.reference.angle - left.reference.angle) > rules.angle_separate)
            continue;
        const double turn = (rules.distance_turn - apart) / (rules.distance_turn - rules.distance_separate);
        const double common = mean_of(right.reference, right.size, left.reference, left.size).angle;
        groups[i].reference.angle += turn * (common - right.reference.angle);
        groups[i + 1].reference.angle += turn * (common - left.reference.angle);
    }
}

}  // namespace

std::vector<RegionGroup> group_regions(const std::vector<OverlapRegion>& regions, const PatchRules& rules, bool blends,
                                       const RailSurface& rail) {
    std::vector<RegionGroup> parts;
    for (const OverlapRegion& region : regions)
        parts.push_back({region.reference, {region}, {}, region.x, region.y, region.z, region.size});
    parts = joined(parts, rules.distance_combine, rules.angle_separate);
    const double middle = 0.5 * (rail.visible().from + rail.visible().to);
    // The mean of regions beside a gap in the rail may have no rail below it. Then it is that of the largest region.
    const auto put_on_rail = [&](RegionGroup& group) {
        ContactReference& at = group.reference;
        at.z = rail.height(at.x, at.y, middle);
        if (std::isfinite(at.z)) return;
        const auto& largest = *std::max_element(group.regions.begin(), group.regions.end(),
                                                [](const auto& a, const auto& b) { return a.size < b.size; });
        at = {largest.reference.x, largest.reference.y, largest.reference.z, at.angle};
    };
    for (RegionGroup& part : parts) {
        if (part.regions.size() < 2) continue;
        put_on_rail(part);
        part.regions.assign(1, merged(part));
    }
    std::vector<RegionGroup> groups = parts;
    if (blends) {
        groups = joined(parts, rules.distance_separate, rules.angle_separate);
        turn_neighbours(groups, rules);
    }
    for (RegionGroup& group : groups) {
        group.shares = shares_of(group.regions, rules);
        group.reference.angle = away_from_upright(group.reference.angle);
        put_on_rail(group);
    }
    return groups;
}

}  // namespace contactd::geometry

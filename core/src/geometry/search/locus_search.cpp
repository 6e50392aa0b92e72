#include "geometry/search/locus_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace contactd::geometry {

std::vector<OverlapRegion> LocusSearch::regions(double z) {
    locus_.look_below(z);
    const std::vector<LocusRow>& rows = locus_.rows();
    std::vector<OverlapRegion> regions;
    for (std::size_t end = rows.size(); end > 0;) {
        if (!(rows[end - 1].gap < z)) {
            --end;
            continue;
        }
        std::size_t begin = end - 1;
        while (begin > 0 && rows[begin - 1].gap < z) --begin;
        regions.push_back(region_of(begin, end, z));
        end = begin;
    }
    return regions;
}

// The weight of a row is the integral over x of the squared penetration there, 16/15 (-g)^2.5/sqrt(a).
OverlapRegion LocusSearch::region_of(std::size_t begin, std::size_t end, double z) const {
    const std::vector<LocusRow>& rows = locus_.rows();
    const double a = locus_.curvature(), half_of_root = 1 / std::sqrt(a);
    OverlapRegion region;
    double sum = 0;
    ContactReference mean;
    Extent x{rows[begin].x, rows[begin].x};
    for (std::size_t i = begin; i < end; ++i) {
        const double depth = z - rows[i].gap, root = std::sqrt(depth), weight = depth * depth * root;
        sum += weight;
        mean.x += weight * rows[i].x;
        mean.y += weight * rows[i].y;
        mean.angle += weight * rows[i].angle;
        const double half = half_of_root * root;
        x = {std::min(x.from, rows[i].x - half), std::max(x.to, rows[i].x + half)};
        region.penetration = std::max(region.penetration, depth);
    }
    region.reference = {mean.x / sum, mean.y / sum, 0, mean.angle / sum};
    region.reference.z = rail_.height(region.reference.x, region.reference.y, rows[(begin + end) / 2].rail_s);
    region.x = x;
    const LocusRow from = edge(begin, -1, z), to = edge(end - 1, 1, z);
    region.y = {from.y, to.y};
    region.z = {from.rail_z, to.rail_z};
    region.size = locus_.step() * 16.0 / 15 * sum * half_of_root;
    return region;
}

/// Returns the point where the gap is z beside the last row inside, or that row itself if nothing is known beyond it.
LocusRow LocusSearch::edge(std::size_t inside, long step, double z) const {
    const long next = static_cast<long>(inside) + step;
    const std::vector<LocusRow>& rows = locus_.rows();
    if (next < 0 || next >= static_cast<long>(rows.size())) return rows[inside];
    const auto outside = static_cast<std::size_t>(next);
    if (!std::isfinite(rows[outside].gap)) return rows[inside];
    if (ends_ == Ends::exact) return locus_.crossing(inside, outside, z);
    const LocusRow &in = rows[inside], &out = rows[outside];
    const double share = (z - in.gap) / (out.gap - in.gap);
    LocusRow end;
    end.y = in.y + share * (out.y - in.y);
    end.rail_z = in.rail_z + share * (out.rail_z - in.rail_z);
    return end;
}

// A row of depth d overlaps as d - a x^2: its volume is 4/3 d^1.5/sqrt(a), and the mean of x^2 over it d/(5 a). For an
// ellipse's paraboloid, the mean is a sixth of the square of its semi-axis, and the volume half of approach times area.
EquivalentEllipse LocusSearch::ellipse(double z, const RegionGroup& group) const {
    const double a = locus_.curvature();
    double volume = 0, along = 0, first = 0, second = 0;
    for (const LocusRow& row : locus_.rows_within(group.y)) {
        if (!(row.gap < z)) continue;
        const double depth = z - row.gap, weight = depth * std::sqrt(depth), aside = row.y - group.reference.y;
        volume += weight;
        along += weight * depth;
        first += weight * aside;
        second += weight * aside * aside;
    }
    const double cosine = std::abs(std::cos(group.reference.angle)), mean = first / volume;
    // A row is as wide as the step, which matters if there is only one.
    const double variance = second / volume - mean * mean + locus_.step() * locus_.step() / 12;
    EquivalentEllipse ellipse;
    ellipse.along = std::sqrt(6.0 / 5 * along / volume / a);
    const double across = std::sqrt(6 * variance) / cosine;
    ellipse.across = std::clamp(across, ellipse.along / most_slender_ellipse, ellipse.along * most_slender_ellipse);
    ellipse.approach =
        2 * volume * locus_.step() * 4.0 / 3 / std::sqrt(a) / (std::numbers::pi * ellipse.along * ellipse.across);
    return ellipse;
}

std::optional<PassedOver> LocusSearch::passed_over(double z) {
    if (!rail_.is_sliced()) return std::nullopt;
    locus_.look_below(z);
    if (!edges_) edges_.emplace(wheel_, rail_);
    if (!edges_->may_reach(locus_, z)) return std::nullopt;
    if (!mesh_) mesh_.emplace(wheel_, rail_, observer_);
    return mesh_->passed_over(locus_, z);
}

QualityFlags LocusSearch::quality_flags(double z, const RegionGroup& group) const {
    QualityFlags flags;
    const double cosine = std::abs(std::cos(group.reference.angle));
    const std::vector<LocusRow>& rows = locus_.rows();
    const std::span<const LocusRow> within = locus_.rows_within(group.y);
    const auto first = static_cast<std::size_t>(within.data() - rows.data());
    double deepest = 0;
    const double mean = std::tan(group.reference.angle);
    Extent rise{mean, mean};
    for (std::size_t i = first; i < first + within.size(); ++i) {
        if (!(rows[i].gap < z)) continue;
        const double depth = z - rows[i].gap;
        if (depth * cosine > surely_pressed)
            rise = {std::min(rise.from, rows[i].rise), std::max(rise.to, rows[i].rise)};
        if (i == 0 || i + 1 == rows.size() || !std::isfinite(rows[i - 1].gap) || !std::isfinite(rows[i + 1].gap))
            flags.at_end = true;
        if (depth < deepest || !rail_.is_sliced()) continue;
        deepest = depth;
        const double half = std::sqrt(depth / locus_.curvature());
        const auto height = [&](double x) { return rail_.height(x, rows[i].y, rows[i].rail_s); };
        const double bulge = height(rows[i].x + half) + height(rows[i].x - half) - 2 * height(rows[i].x);
        flags.curvature = std::abs(bulge) / (2 * depth);
    }
    for (const double end : {rise.from, rise.to})
        flags.bend = std::max(flags.bend, std::abs(std::atan(end) - group.reference.angle));
    return flags;
}

}  // namespace contactd::geometry

#include "geometry/profile/given_points_gradient.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include "contactd/error.hpp"
#include "contactd/read_profile.hpp"
#include "geometry/profile/measured_points.hpp"
#include "geometry/profile/profile_fit.hpp"

namespace contactd::geometry {
namespace {

/// Returns the gradient by points from that by those that a step of cleaning kept in their order, unchanged or as means
/// of two neighbours.
Points by_all(const Points& all, const Points& kept, const Points& by_kept) {
    Points by(all.size());
    const auto add = [&](std::size_t i, double share, const ProfilePoint& more) {
        by[i].y += share * more.y;
        by[i].z += share * more.z;
    };
    for (std::size_t i = 0, k = 0; i < all.size() && k < kept.size(); ++i) {
        if (kept[k] == all[i]) {
            add(i, 1, by_kept[k++]);
        } else if (i + 1 < all.size() &&
                   kept[k] == ProfilePoint{(all[i].y + all[i + 1].y) / 2, (all[i].z + all[i + 1].z) / 2}) {
            add(i, 0.5, by_kept[k]);
            add(++i, 0.5, by_kept[k++]);
        }
    }
    return by;
}

Points by_visible(const Visible& visible, std::size_t count, const Points& by_points) {
    Points by(count);
    for (std::size_t i = 0; i < by_points.size(); ++i) {
        if (!visible.places[i])
            throw InvalidArgument("profile.points",
                                  "have a large part that is hidden from above, for which there are no gradients; omit "
                                  "the hidden points");
        by[*visible.places[i]] = by_points[i];
    }
    return by;
}

Points by_measured(const ProfilePoints& given, ProfileKind kind, const Fit& fit, const Points& by_points) {
    const Points in_mm = points_in_mm(given), first = without_repetitions(in_mm), second = without_zigzags(first),
                 points = without_repetitions(second);
    const auto kinks = kinks_of(points, fit.kinks);
    const ProfileCurve rough(points, kinks);
    const Visible visible = visible_part(fit.smooths() ? smoothed(rough, fit) : points, kinks, kind);
    Points by = by_visible(visible, points.size(), by_points);
    if (fit.smooths()) by = by_rough_points(rough, fit, by);
    by = by_all(in_mm, first, by_all(first, second, by_all(second, points, by)));
    if (given.points.front().y * (given.mirror_y ? -1 : 1) > given.points.back().y * (given.mirror_y ? -1 : 1))
        std::reverse(by.begin(), by.end());
    for (ProfilePoint& point : by) {
        point.y *= given.mirror_y ? -given.unit : given.unit;
        point.z *= given.mirror_z ? -given.unit : given.unit;
    }
    return by;
}

}  // namespace

std::vector<ProfilePoint> by_given_points(const ProfileSpec& spec, const std::vector<ProfilePoint>& by_points) {
    if (const auto* given = std::get_if<ProfilePoints>(&spec.shape))
        return by_measured(*given, spec.kind, fit_of(*given), by_points);
    if (const auto* file = std::get_if<ProfileFile>(&spec.shape)) {
        const PointsOfFile read = points_of(*file, spec.kind);
        return naming_file(*file, [&] { return by_measured(read.points, spec.kind, fit_of(*file), by_points); });
    }
    return by_points;
}

}  // namespace contactd::geometry

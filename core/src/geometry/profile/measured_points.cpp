#include "geometry/profile/measured_points.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "profile_files/points_upwards.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double widest = 1000;         // mm
constexpr double flange_height = 10;    // mm: least height of a flange, and of the sides of a rail
constexpr double flange_to_tread = 40;  // mm: a narrower profile is a flange alone, which may be cut off anywhere

std::string text_of(const ProfilePoint& point) {
    return "(" + number_text(point.y) + ", " + number_text(point.z) + ")";
}

/// Throws if too little remains, because a profile is not ordered, or stands upright.
void check_remainder(std::size_t kept, std::size_t given) {
    if (2 * kept < given)
        throw InvalidArgument("profile.points", "has " + std::to_string(given) + " entries, of which only " +
                                                    std::to_string(kept) +
                                                    " are in order when seen from above; they must follow the profile "
                                                    "from one end to the other, with y ascending or descending");
}

void check_sense(const Points& points, ProfileKind kind) {
    const auto [upper, lower] =
        std::minmax_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
    std::vector<double> heights;
    for (const ProfilePoint& point : points) heights.push_back(point.z);
    const auto median = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), median, heights.end());
    const double usual = *median, centre = (points.front().y + points.back().y) / 2;
    if (kind == ProfileKind::wheel) {
        const std::optional<Flange> flange = flange_of(points);
        const bool shows_tread = points.back().y - points.front().y > flange_to_tread;
        if (flange && flange->upwards)
            throw InvalidArgument("profile.points",
                                  "rise to z = " + number_text(upper->z) + " at y = " + number_text(upper->y) +
                                      ", but z points downwards, to the tip of the flange: change mirror_z");
        // A steady slope to one side is a cone, not a flange.
        const bool deep = lower->z - usual > std::max(flange_height, 2 * (usual - upper->z));
        if ((flange && !flange->is_left && shows_tread) || (deep && lower->y > centre))
            throw InvalidArgument("profile.points", "have the flange at y = " + number_text(lower->y) +
                                                        ", but y points to the field side: change mirror_y");
    } else if (const double half = (upper->z + lower->z) / 2; std::max(points.front().z, points.back().z) < half &&
                                                              usual > half && lower->z - upper->z > flange_height)
        throw InvalidArgument("profile.points", "have both ends near the top, z = " + number_text(upper->z) +
                                                    ", and the others below, but z points downwards: change mirror_z");
}

}  // namespace

Points points_in_mm(const ProfilePoints& given) {
    Points points = given.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ProfilePoint& point = points[i];
        point.y *= given.mirror_y ? -given.unit : given.unit;
        point.z *= given.mirror_z ? -given.unit : given.unit;
        if (!(std::abs(point.y) <= 1e5 && std::abs(point.z) <= 1e5))
            throw InvalidArgument("profile.points[" + std::to_string(i) + "]",
                                  "is " + text_of(given.points[i]) +
                                      "; coordinates must be finite and at most 1e5 mm: correct the point or the unit");
    }
    if (points.size() > 1 && points.front().y > points.back().y) std::reverse(points.begin(), points.end());
    return points;
}

Points measured_points(const ProfilePoints& given, ProfileKind kind) {
    if (given.points.size() < 2)
        throw InvalidArgument("profile.points",
                              "has " + std::to_string(given.points.size()) +
                                  " entries; a profile needs at least two points, and a measured one about fifty");
    // The mean of a zigzag may coincide with its neighbour.
    const Points points = without_repetitions(without_zigzags(without_repetitions(points_in_mm(given))));
    if (const auto crossing = crossing_of(points); crossing.found())
        throw InvalidArgument("profile.points",
                              "cross themselves: the chord from " + text_of(points[crossing.first]) +
                                  " and the one from " + text_of(points[crossing.second]) +
                                  " meet (mm, cleaned); order the points along the profile, or omit those of the loop");
    const Points seen = points.empty() ? points : seen_from_above(points, kind);
    check_remainder(seen.size(), points.size());
    if (seen.size() < 2 || seen.back().y - seen.front().y < 1)
        throw InvalidArgument("profile.points", "span less than 1 mm laterally; check their unit");
    if (seen.back().y - seen.front().y > widest)
        throw InvalidArgument("profile.points", "span " + number_text(seen.back().y - seen.front().y) +
                                                    " mm laterally, but no wheel or rail is wider than " +
                                                    number_text(widest) + "; check their unit");
    check_sense(seen, kind);
    return points;
}

}  // namespace contactd::geometry

#include "geometry/profile/formula_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/profile/stretches.hpp"

namespace contactd::geometry {
namespace {

constexpr double pi = std::numbers::pi;

/// Describes the head of an upright 60E1, its top at the origin: the half with y > 0, from the top to the widest point.
struct Head60E1 {
    static constexpr double top_width = 10.5, shoulder_width = 25.988, widest = 37.15;  // half widths (mm)
    double to_shoulder = std::asin(top_width / 300);  // inclination of the normal there
    ProfilePoint shoulder_centre{220 * std::sin(to_shoulder), 300 - 220 * std::cos(to_shoulder)};
    double to_corner = std::asin((shoulder_width - shoulder_centre.y) / 80);
    ProfilePoint corner_centre{shoulder_centre.y + 67 * std::sin(to_corner),
                               shoulder_centre.z - 67 * std::cos(to_corner)};
    double to_side = pi / 2 - std::atan(1.0 / 20);
    ProfilePoint side{corner_centre.y + 13 * std::sin(to_side), corner_centre.z - 13 * std::cos(to_side)};
    ProfilePoint lowest{widest, side.z + 20 * (widest - side.y)};

    /// Returns the highest point of a head inclined towards y < 0: z of the centre of its arc, and the arc's radius.
    std::pair<ProfilePoint, double> top_arc(double angle) const {
        if (angle <= to_shoulder) return {{0, 300}, 300};
        return angle <= to_corner ? std::pair(shoulder_centre, 80.0) : std::pair(corner_centre, 13.0);
    }
};

/// Bends the last 3 mm of a stretch at both ends to meet other points.
Stretch bent(const Stretch& stretch, const ProfilePoint& begin, const ProfilePoint& end) {
    const double z_begin = begin.z - stretch.at(0).z, z_end = end.z - stretch.at(stretch.length).z;
    return {stretch.length, [=](double t) {
                const auto share = [](double distance) {
                    const double near = std::max(0.0, 1 - distance / 3);
                    return near * near * (3 - 2 * near);
                };
                const ProfilePoint at = stretch.at(t);
                return ProfilePoint{at.y, at.z + z_begin * share(t) + z_end * share(stretch.length - t)};
            }};
}

}  // namespace

std::vector<ProfilePoint> formula_points(const S1002&) {
    // The arcs of the flange touch each other and the straight line, so joints follow from their centres.
    constexpr ProfilePoint back{-49.5, 9.519259302}, tip{-55, 16}, front{-58.558326413, 8.834924130},
        root{-26.210665, 16.446};
    constexpr double slope = -2.747477419;  // 70 degrees
    const double back_to_tip = std::atan2(tip.z - back.z, tip.y - back.y);
    const double tip_to_front = std::atan2(tip.z - front.z, tip.y - front.y);
    const double to_line = std::atan(-1 / slope);  // of the line's normal
    const Stretch front_arc = arc(front, 20, tip_to_front, to_line);
    const Stretch root_arc = arc(root, 13, pi + to_line, pi + std::acos((root.y + 35) / 13));
    const Stretch tread = polynomial({0, -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8,
                                      -1.562379023e-8, 5.309217349e-15, -5.957839843e-12, 2.646656573e-13},
                                     -26, 32.15796);
    // Its coefficients are rounded, so that it misses its neighbours by 1.2e-4 and 3.7e-5 mm.
    const Stretch throat = bent(polynomial({-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875,
                                            -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7},
                                           -35, -26),
                                root_arc.at(root_arc.length), tread.at(0));
    const std::array stretches{arc(back, 20.5, pi, back_to_tip),
                               arc(tip, 12, back_to_tip, tip_to_front),
                               front_arc,
                               straight(front_arc.at(front_arc.length), root_arc.at(0)),
                               root_arc,
                               throat,
                               tread,
                               polynomial({1.364323640, -0.066666667}, 32.15796, 60)};
    return points_along(stretches);
}

std::vector<ProfilePoint> formula_points(const Rail60E1& rail) {
    // The published head of 1/40 is rotated about this point, 0.24 mm above the centre of R300.
    constexpr ProfilePoint pivot{0, 299.762};
    const Head60E1 head;
    const auto inclination = [](double normal) { return normal - pi / 2; };  // angle in an arc from that of its normal
    const std::array stretches{
        straight({-head.lowest.y, head.lowest.z}, {-head.side.y, head.side.z}),
        arc({-head.corner_centre.y, head.corner_centre.z}, 13, inclination(-head.to_side),
            inclination(-head.to_corner)),
        arc({-head.shoulder_centre.y, head.shoulder_centre.z}, 80, inclination(-head.to_corner),
            inclination(-head.to_shoulder)),
        arc({0, 300}, 300, inclination(-head.to_shoulder), inclination(head.to_shoulder)),
        arc(head.shoulder_centre, 80, inclination(head.to_shoulder), inclination(head.to_corner)),
        arc(head.corner_centre, 13, inclination(head.to_corner), inclination(head.to_side)),
        straight(head.side, head.lowest)};
    const double angle = std::atan(rail.inclination);
    const auto rotated = [&](const ProfilePoint& point) {
        const double y = point.y - pivot.y, z = point.z - pivot.z;
        return ProfilePoint{pivot.y + std::cos(angle) * y + std::sin(angle) * z,
                            pivot.z - std::sin(angle) * y + std::cos(angle) * z};
    };
    auto [centre, radius] = head.top_arc(std::abs(angle));
    if (angle < 0) centre.y = -centre.y;
    const double top = rotated(centre).z - radius;
    auto points = points_along(stretches);
    for (ProfilePoint& point : points) {
        point = rotated(point);
        point.z -= top;
    }
    return points;
}

std::vector<ProfilePoint> formula_points(const ArcProfile& profile) {
    // The sine of the angle of the normal is linear in y.
    const double leaning = std::atan(profile.slope), radius = profile.radius;
    const ProfilePoint centre{-radius * std::sin(leaning), radius * std::cos(leaning)};
    const auto angle = [&](double y) {
        const double normal = std::asin((y - centre.y) / radius);
        return radius > 0 ? normal - pi / 2 : pi / 2 + normal;
    };
    const std::array stretches{arc(centre, std::abs(radius), angle(profile.from), angle(profile.to))};
    return points_along(stretches);
}

std::vector<ProfilePoint> formula_points(const ConeProfile& cone) {
    return {{cone.from, cone.slope * cone.from}, {0, 0}, {cone.to, cone.slope * cone.to}};
}

}  // namespace contactd::geometry

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "contactd/error.hpp"
#include "geometry/profile/formula_points.hpp"
#include "geometry/profile/stretches.hpp"

namespace contactd::geometry {
namespace {

struct HeadArc {
    double radius, width;  // mm; `width` is that of the head at the lower end of the arc
};

/// Holds the dimensions of a head in its drawing: arcs from the top on, then a straight side down to the fillet.
struct StandardHead {
    StandardName name;
    std::array<HeadArc, 4> arcs;    // the last one ends at the side and has no width; unused ones have no radius
    double side;                    // dz/dy of the side at y > 0
    double underside, low, fillet;  // of the underside: -dy/dz, z at y = 0; radius of the fillet to the side
};

/// EN 13674-1:2017, annex A. The public package EN13674 of A. Rohrbeck (2022) contains each of these dimensions.
/// docs/profiles.md names the points with which each head was compared.
constexpr std::array heads{
    StandardHead{StandardName::n49E5, {{{115, 41.342}, {16.5, 62.980}, {15.5, 66}, {7.64, 0}}}, 17.2, 3, 51.5, 2},
    StandardHead{StandardName::n54E1, {{{300, 20.024}, {80, 49.727}, {13, 0}}}, 20, 2.75, 49.4, 3},
    StandardHead{StandardName::n54E3, {{{300, 15.267}, {80, 46.835}, {13, 0}}}, 17.2, 3, 55, 5},
    StandardHead{StandardName::n60E1, {{{300, 20.456}, {80, 52.053}, {13, 0}}}, 20, 2.75, 51, 3},
    StandardHead{StandardName::n60E2, {{{200, 23.778}, {70, 48.913}, {16, 70.774}, {8, 0}}}, 20, 2.75, 51, 3}};

const StandardHead& head_of(StandardName name) {
    for (const StandardHead& head : heads)
        if (head.name == name) return head;
    throw Error("A standard profile has no head.");
}

/// An arc of an upright head, where y > 0, from one inclination to the next.
struct PlacedArc {
    ProfilePoint centre;
    double radius, from, to;

    ProfilePoint end() const { return {centre.y + radius * std::sin(to), centre.z - radius * std::cos(to)}; }
    Stretch stretch() const { return arc(centre, radius, from - std::numbers::pi / 2, to - std::numbers::pi / 2); }
};

/// Places the arcs so that each continues the previous one with the same tangent.
std::vector<PlacedArc> placed_arcs(const StandardHead& head) {
    std::vector<PlacedArc> placed;
    ProfilePoint start;
    double inclination = 0;
    for (const auto& [radius, width] : head.arcs) {
        if (radius == 0) break;
        const ProfilePoint centre{start.y - radius * std::sin(inclination), start.z + radius * std::cos(inclination)};
        const double end = width == 0 ? std::atan(head.side) : std::asin((width / 2 - centre.y) / radius);
        placed.push_back({centre, radius, inclination, end});
        start = placed.back().end();
        inclination = end;
    }
    return placed;
}

/// Returns the straight side from the last arc to the fillet between side and underside.
Stretch side_of(const StandardHead& head, ProfilePoint start) {
    const double rise = 1 / head.underside;
    const double corner = (head.low - start.z + head.side * start.y) / (head.side + rise);
    const double cut = head.fillet / std::tan((std::atan(head.side) + std::atan(rise)) / 2);
    const double end = corner - cut / std::hypot(1, head.side);
    return straight(start, {end, start.z + head.side * (end - start.y)});
}

Stretch mirrored(const Stretch& stretch) {
    return {stretch.length, [=](double t) {
                const ProfilePoint at = stretch.at(stretch.length - t);
                return ProfilePoint{-at.y, at.z};
            }};
}

}  // namespace

std::vector<ProfilePoint> formula_points(const StandardProfile& profile) {
    if (profile.name == StandardName::S1002) return formula_points(S1002{});
    if (profile.name == StandardName::UIC60) return formula_points(Rail60E1{profile.inclination});
    const StandardHead& head = head_of(profile.name);
    const auto arcs = placed_arcs(head);
    std::vector<Stretch> right;
    for (std::size_t i = 1; i < arcs.size(); ++i) right.push_back(arcs[i].stretch());
    right.push_back(side_of(head, arcs.back().end()));
    std::vector<Stretch> stretches;
    for (auto stretch = right.rbegin(); stretch != right.rend(); ++stretch) stretches.push_back(mirrored(*stretch));
    const PlacedArc& top = arcs.front();
    stretches.push_back(arc(top.centre, top.radius, -top.to - std::numbers::pi / 2, top.to - std::numbers::pi / 2));
    std::ranges::move(right, std::back_inserter(stretches));

    // The head is rotated about the centre of its first arc, so that the top stays where it is on this arc.
    const double angle = std::atan(profile.inclination);
    const auto turned = [&](const ProfilePoint& point) {
        const double z = point.z - top.radius;
        return ProfilePoint{std::cos(angle) * point.y + std::sin(angle) * z,
                            top.radius - std::sin(angle) * point.y + std::cos(angle) * z};
    };
    std::size_t highest = 0;
    while (std::abs(angle) > arcs[highest].to) ++highest;
    ProfilePoint centre = arcs[highest].centre;
    centre.y = std::copysign(centre.y, angle);
    const double above = turned(centre).z - arcs[highest].radius;
    auto points = points_along(stretches);
    for (ProfilePoint& point : points) {
        point = turned(point);
        point.z -= above;
    }
    return points;
}

}  // namespace contactd::geometry

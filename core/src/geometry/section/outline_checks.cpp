#include "geometry/section/outline_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "contactd/error.hpp"
#include "geometry/section/place_text.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

using Polygon = std::vector<SectionPoint>;

// Returns twice the area, positive anticlockwise.
double twice_area(const Polygon& polygon) {
    const SectionPoint& o = polygon.front();
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const SectionPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        sum += (a.y - o.y) * (b.z - o.z) - (b.y - o.y) * (a.z - o.z);
    }
    return sum;
}

bool inside(const SectionPoint& point, const Polygon& polygon) {
    bool odd = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const SectionPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.z > point.z) != (b.z > point.z) && point.y < a.y + (point.z - a.z) / (b.z - a.z) * (b.y - a.y))
            odd = !odd;
    }
    return odd;
}

// Describes one chord of a curve.
struct Chord {
    SectionPoint a, b;
    std::size_t curve, index;
};

using Coordinate = double SectionPoint::*;
double low(const Chord& chord, Coordinate along) {
    return std::min(chord.a.*along, chord.b.*along);
}
double high(const Chord& chord, Coordinate along) {
    return std::max(chord.a.*along, chord.b.*along);
}
bool apart(const Chord& p, const Chord& q, Coordinate along, double by = 0) {
    return high(p, along) + by < low(q, along) || high(q, along) + by < low(p, along);
}

double side(const SectionPoint& a, const SectionPoint& b, const SectionPoint& point) {
    return (b.y - a.y) * (point.z - a.z) - (b.z - a.z) * (point.y - a.y);
}

bool within(const SectionPoint& a, const SectionPoint& b, const SectionPoint& point) {
    return std::min(a.y, b.y) <= point.y && point.y <= std::max(a.y, b.y) && std::min(a.z, b.z) <= point.z &&
           point.z <= std::max(a.z, b.z);
}

// Returns a point where two chords cross or touch.
std::optional<SectionPoint> common_point(const Chord& p, const Chord& q) {
    if (apart(p, q, &SectionPoint::y) || apart(p, q, &SectionPoint::z)) return {};
    const double a = side(q.a, q.b, p.a), b = side(q.a, q.b, p.b), c = side(p.a, p.b, q.a), d = side(p.a, p.b, q.b);
    if ((a > 0) != (b > 0) && (c > 0) != (d > 0) && a != b) {
        const double t = a / (a - b);
        return SectionPoint{p.a.y + t * (p.b.y - p.a.y), p.a.z + t * (p.b.z - p.a.z)};
    }
    if (a == 0 && within(q.a, q.b, p.a)) return p.a;
    if (b == 0 && within(q.a, q.b, p.b)) return p.b;
    if (c == 0 && within(p.a, p.b, q.a)) return q.a;
    if (d == 0 && within(p.a, p.b, q.b)) return q.b;
    return {};
}

double distance(const SectionPoint& point, const Chord& chord) {
    const double dy = chord.b.y - chord.a.y, dz = chord.b.z - chord.a.z, y = point.y - chord.a.y,
                 z = point.z - chord.a.z, t = std::clamp((y * dy + z * dz) / (dy * dy + dz * dz), 0.0, 1.0);
    return std::hypot(y - t * dy, z - t * dz);
}

// Returns a point where two chords that do not meet are closer to each other than `least`.
std::optional<SectionPoint> close_point(const Chord& p, const Chord& q, double least) {
    if (apart(p, q, &SectionPoint::y, least) || apart(p, q, &SectionPoint::z, least)) return {};
    for (const SectionPoint& end : {p.a, p.b})
        if (distance(end, q) < least) return end;
    for (const SectionPoint& end : {q.a, q.b})
        if (distance(end, p) < least) return end;
    return {};
}

void check_corners(const ClosedCurve& curve, const std::string& name) {
    for (std::size_t i = 0; i < curve.pieces().size(); ++i)
        if (std::abs(curve.turn_before(i)) > std::numbers::pi - 1e-6)
            throw InvalidArgument(name, "turns back on itself at " + place_text(curve.pieces()[i].place(0).at) +
                                            "; the body must have a thickness there");
}

void check_crossings(const std::vector<Polygon>& polygons, const std::vector<std::string>& names) {
    std::vector<Chord> chords;
    for (std::size_t curve = 0; curve < polygons.size(); ++curve)
        for (std::size_t i = 0; i < polygons[curve].size(); ++i)
            chords.push_back({polygons[curve][i], polygons[curve][(i + 1) % polygons[curve].size()], curve, i});
    // The chords are sorted along the axis on which they overlap less.
    const auto extent = [&](Coordinate along) {
        const auto [first, last] = std::minmax_element(
            chords.begin(), chords.end(), [&](const Chord& p, const Chord& q) { return p.a.*along < q.a.*along; });
        return last->a.*along - first->a.*along;
    };
    const auto spread = [&](Coordinate along) {
        double sum = 0;
        for (const Chord& chord : chords) sum += high(chord, along) - low(chord, along);
        return sum / extent(along);
    };
    // This is the least distance between two curves, over the body. With less, rounding errors dominate the stiffness
    // of the section.
    constexpr double least_bridge = 2e-6;
    const double least = least_bridge * std::max(extent(&SectionPoint::y), extent(&SectionPoint::z));
    const Coordinate along = spread(&SectionPoint::y) < spread(&SectionPoint::z) ? &SectionPoint::y : &SectionPoint::z;
    std::sort(chords.begin(), chords.end(),
              [&](const Chord& p, const Chord& q) { return low(p, along) < low(q, along); });
    for (std::size_t i = 0; i < chords.size(); ++i)
        for (std::size_t k = i + 1; k < chords.size() && low(chords[k], along) <= high(chords[i], along) + least; ++k) {
            const Chord &p = chords[i], &q = chords[k];
            const std::size_t between = p.index > q.index ? p.index - q.index : q.index - p.index;
            const bool neighbours = between == 1 || between + 1 == polygons[p.curve].size();
            if (p.curve == q.curve && neighbours) continue;
            if (const auto at = common_point(p, q)) {
                if (p.curve == q.curve)
                    throw InvalidArgument(names[p.curve], "crosses or touches itself at " + place_text(*at) +
                                                              "; its parts may touch at their ends only");
                throw InvalidArgument(names[std::max(p.curve, q.curve)],
                                      "crosses or touches " + names[std::min(p.curve, q.curve)] + " at " +
                                          place_text(*at) + "; the body must separate them");
            }
            if (p.curve == q.curve) continue;
            if (const auto at = close_point(p, q, least))
                throw InvalidArgument(names[std::max(p.curve, q.curve)],
                                      "leaves less than " + short_text(least) + " mm of the body between it and " +
                                          names[std::min(p.curve, q.curve)] + " at " + place_text(*at) +
                                          ", 2e-6 of its extent; increase the distance, or merge the curves");
        }
}

void check_sense(const Polygon& polygon, bool outside, const std::string& name) {
    const double area = twice_area(polygon);
    if (area == 0) throw InvalidArgument(name, "encloses no area; it begins at " + place_text(polygon.front()));
    if ((area > 0) == outside)
        throw InvalidArgument(
            name, "runs " + std::string(outside ? "anticlockwise" : "clockwise") + " from " +
                      place_text(polygon.front()) +
                      ", so the body would lie on its left; reverse the order of its parts and the signs of radii");
}

}  // namespace

void check_outlines(const std::vector<ClosedCurve>& curves, const std::vector<std::string>& names) {
    std::vector<Polygon> polygons;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        check_corners(curves[i], names[i]);
        polygons.push_back(curves[i].points());
    }
    check_crossings(polygons, names);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        check_sense(polygons[i], i == 0, names[i]);
        const SectionPoint& point = polygons[i].front();
        if (i > 0 && !inside(point, polygons[0]))
            throw InvalidArgument(names[i], "lies outside the body, at " + place_text(point));
        for (std::size_t k = 1; k < i; ++k)
            if (inside(point, polygons[k]) || inside(polygons[k].front(), polygons[i]))
                throw InvalidArgument(names[i], "overlaps " + names[k] + ": one lies within the other at " +
                                                    place_text(point) + "; merge them into one hole");
    }
}

}  // namespace contactd::geometry

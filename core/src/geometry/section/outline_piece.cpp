#include "geometry/section/outline_piece.hpp"

#include <algorithm>

#include "contactd/error.hpp"
#include "geometry/section/place_text.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double turn_step = 2 * std::numbers::pi / 180;  // rotation of the tangent from point to point
constexpr int most_spline_steps = 8;                      // between adjacent points

// Returns the least length at which two points are distinct.
double least_length(const SectionPoint& a, const SectionPoint& b) {
    return 1e-12 * std::max({std::abs(a.y), std::abs(a.z), std::abs(b.y), std::abs(b.z)});
}

double chord(const SectionPoint& from, const SectionPoint& to, const std::string& field) {
    const double length = std::hypot(to.y - from.y, to.z - from.z);
    if (!(length > least_length(from, to)))
        throw InvalidArgument(
            field, "has no length: it begins and ends at " + place_text(from) + "; remove it, or change its end");
    return length;
}

OutlinePlace place_on(const ProfileCurve& curve, double s) {
    const auto here = curve.place(curve.s_at_arc_length(s));
    const double speed = std::hypot(here.slope.y, here.slope.z);
    const double bending = here.slope.z * here.curving.y - here.slope.y * here.curving.z;
    return {{here.at.y, here.at.z}, std::atan2(-here.slope.z, here.slope.y), bending / (speed * speed * speed)};
}

}  // namespace

OutlinePiece::OutlinePiece(const SectionPoint& from, const OutlinePart& part, const std::string& field)
    : shape_(Line{}), clamped_(part.clamped) {
    std::visit([&](const auto& curve) { draw(from, curve, field); }, part.curve);
}

void OutlinePiece::draw(const SectionPoint& from, const LineTo& line, const std::string& field) {
    length_ = chord(from, line.to, field);
    shape_ = Line{from, std::atan2(from.z - line.to.z, line.to.y - from.y)};
}

void OutlinePiece::draw(const SectionPoint& from, const ArcTo& arc, const std::string& field) {
    const double half = chord(from, arc.to, field) / 2, size = std::abs(arc.radius);
    if (half > size * (1 + 1e-9))
        throw InvalidArgument(field + ".arc.radius", "is " + number_text(arc.radius) + ", too small for an arc from " +
                                                         place_text(from) + " to " + place_text(arc.to) +
                                                         "; its magnitude must be at least " + short_text(half) +
                                                         " mm");
    const double sine = std::min(1.0, half / size), towards = arc.radius * std::sqrt((1 - sine) * (1 + sine));
    const SectionPoint right{(arc.to.z - from.z) / (2 * half), -(arc.to.y - from.y) / (2 * half)};
    const SectionPoint centre{(from.y + arc.to.y) / 2 + towards * right.y, (from.z + arc.to.z) / 2 + towards * right.z};
    const double sign = arc.radius > 0 ? 1 : -1;
    shape_ = Arc{centre, arc.radius, std::atan2(sign * (from.y - centre.y), sign * (from.z - centre.z))};
    length_ = 2 * size * std::asin(sine);
}

void OutlinePiece::draw(const SectionPoint& from, const SplineTo& spline, const std::string& field) {
    std::vector<ProfilePoint> points{{from.y, from.z}};
    for (const SectionPoint& point : spline.through) points.push_back({point.y, point.z});
    try {
        ProfileCurve curve(std::move(points));
        length_ = curve.arc_length(curve.end());
        shape_ = std::move(curve);
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(field + ".spline",
                              std::string("cannot be drawn: if points[0] is its start, ") + error.what());
    }
}

OutlinePlace OutlinePiece::place(double s) const {
    if (const auto* line = std::get_if<Line>(&shape_))
        return {{line->from.y + s * std::cos(line->angle), line->from.z - s * std::sin(line->angle)}, line->angle, 0};
    if (const auto* arc = std::get_if<Arc>(&shape_)) {
        const double angle = arc->angle + s / arc->radius;
        const SectionPoint at{arc->centre.y + arc->radius * std::sin(angle),
                              arc->centre.z + arc->radius * std::cos(angle)};
        return {at, principal(angle), 1 / arc->radius};
    }
    return place_on(std::get<ProfileCurve>(shape_), s);
}

std::vector<SectionPoint> OutlinePiece::points() const {
    int steps = 1;
    if (const auto* arc = std::get_if<Arc>(&shape_))
        steps = 1 + static_cast<int>(length_ / (std::abs(arc->radius) * turn_step));
    std::vector<SectionPoint> result;
    if (const auto* curve = std::get_if<ProfileCurve>(&shape_)) {
        const auto& knots = curve->knots();
        for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
            // The curvature between two points of a spline lies between theirs.
            const double width = knots[i + 1] - knots[i];
            const double most =
                std::max(std::abs(curve->curvature(knots[i])), std::abs(curve->curvature(knots[i + 1])));
            const double angular_steps = most * width / turn_step;
            const int parts =
                angular_steps < most_spline_steps ? 1 + static_cast<int>(angular_steps) : most_spline_steps;
            for (int part = 0; part < parts; ++part) {
                const ProfilePoint at = curve->at(knots[i] + part * width / parts);
                result.push_back({at.y, at.z});
            }
        }
    } else {
        for (int step = 0; step < steps; ++step) result.push_back(place(step * length_ / steps).at);
    }
    return result;
}

SectionPoint end_of(const OutlinePart& part) {
    if (const auto* line = std::get_if<LineTo>(&part.curve)) return line->to;
    if (const auto* arc = std::get_if<ArcTo>(&part.curve)) return arc->to;
    return std::get<SplineTo>(part.curve).through.back();
}

}  // namespace contactd::geometry

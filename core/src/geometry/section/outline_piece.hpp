// Represents a smooth piece of an outline by its arc length: a line, an arc, or a spline.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "contactd/profile.hpp"
#include "contactd/section.hpp"

namespace contactd::geometry {

/// Returns the equivalent angle in [-pi, pi].
inline double principal(double angle) {
    return std::remainder(angle, 2 * std::numbers::pi);
}

/// Holds the point, normal and curvature at an arc length.
struct OutlinePlace {
    SectionPoint at;
    double angle = 0;      ///< angle of the outward normal, as in a StripFrame, in [-pi, pi]
    double curvature = 0;  ///< d angle / d arc length (1/mm): positive where the body is convex

    SectionPoint tangent() const { return {std::cos(angle), -std::sin(angle)}; }
    SectionPoint normal() const { return {std::sin(angle), std::cos(angle)}; }
};

class OutlinePiece {
   public:
    /// Throws InvalidArgument, which names `field`, for a length of zero, for an arc that does not reach its end, and
    /// for a spline whose points coincide or lie beyond 1e5 mm.
    OutlinePiece(const SectionPoint& from, const OutlinePart& part, const std::string& field);

    double length() const { return length_; }
    bool clamped() const { return clamped_; }
    OutlinePlace place(double s) const;  ///< 0 <= s <= length
    /// Returns points along it from s = 0 on, without its end, so close that the angle between adjacent chords is
    /// small.
    std::vector<SectionPoint> points() const;

   private:
    struct Line {
        SectionPoint from;
        double angle;
    };
    struct Arc {
        SectionPoint centre;
        double radius;  // signed, as in ArcTo
        double angle;   // angle at its beginning
    };
    using Shape = std::variant<Line, Arc, ProfileCurve>;

    void draw(const SectionPoint& from, const LineTo& line, const std::string& field);
    void draw(const SectionPoint& from, const ArcTo& arc, const std::string& field);
    void draw(const SectionPoint& from, const SplineTo& spline, const std::string& field);

    Shape shape_;
    double length_ = 0;
    bool clamped_;
};

/// Returns the end of a part.
SectionPoint end_of(const OutlinePart& part);

}  // namespace contactd::geometry

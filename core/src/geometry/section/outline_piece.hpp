// A smooth piece of an outline by its arc length: a line, an arc, or a spline.
#pragma once

#include <string>
#include <variant>

#include "contactd/profile.hpp"
#include "contactd/section.hpp"

namespace contactd::geometry {

/// What an arc length leads to.
struct OutlinePlace {
    SectionPoint at;
    double angle = 0;      ///< of the outward normal, as that of a ColumnFrame, in (-pi, pi]
    double curvature = 0;  ///< d angle / d arc length (1/mm): positive where the body is convex

    SectionPoint tangent() const;  ///< unit vectors
    SectionPoint normal() const;
};

class OutlinePiece {
   public:
    /// From `from` on. Throws InvalidArgument naming `field` for no length, and for an arc that does not reach.
    OutlinePiece(const SectionPoint& from, const OutlinePart& part, const std::string& field);

    double length() const { return length_; }
    bool held() const { return held_; }
    OutlinePlace place(double s) const;  ///< 0 <= s <= length
    /// By how much its tangent may turn within ds (rad), and so what an edge of a mesh should not exceed.
    double sharpest_radius() const;

   private:
    struct Line {
        SectionPoint from, direction;
    };
    struct Arc {
        SectionPoint centre;
        double radius;  // signed
        double angle;   // of the outward normal where it begins
    };
    std::variant<Line, Arc, ProfileCurve> shape_;
    double length_ = 0;
    bool held_;
};

}  // namespace contactd::geometry

// Describes the geometry of a cross-section for meshing: closed curves of smooth pieces, by arc length, and the strips
// on one of them. Lengths are divided by the width ds of a strip, so that sections of one shape have one mesh.
#pragma once

#include <functional>
#include <vector>

namespace contactd::fem {

struct PlanePoint {
    double y = 0, z = 0;
};

/// Describes a smooth stretch of an outline; s runs from 0 to `length` with the body on the right.
struct OutlinePiece {
    double length = 0;
    bool clamped = false;
    std::function<PlanePoint(double s)> point;
    std::function<PlanePoint(double s)> normal;  ///< outward, of length one
};

using OutlineLoop = std::vector<OutlinePiece>;

struct SectionOutline {
    std::vector<OutlineLoop> loops;  ///< the outer one first
    std::size_t carrier = 0;         ///< the loop with the strips
    double first_strip = 0;          ///< start of the first strip, in arc length along the loop
    int strips = 0;                  ///< adjacent strips, each of arc length one
};

/// Identifies a point of a loop: a piece, and the arc length along it.
struct OutlinePosition {
    std::size_t loop = 0, piece = 0;
    double s = 0;
};

double length_of(const OutlineLoop& loop);
/// Returns the position at an arc length along a loop, which may exceed the loop's length. At a joint it is on the
/// piece that begins there.
OutlinePosition position_at(const SectionOutline& outline, std::size_t loop, double s);

inline PlanePoint point_at(const SectionOutline& outline, const OutlinePosition& at) {
    return outline.loops[at.loop][at.piece].point(at.s);
}
inline PlanePoint normal_at(const SectionOutline& outline, const OutlinePosition& at) {
    return outline.loops[at.loop][at.piece].normal(at.s);
}

/// Implements two pieces of an outline: a straight one, and an arc about `centre` that begins at angle `from` (rad,
/// from +y towards +z) and turns by `turn` (rad, positive towards +z).
OutlinePiece straight(const PlanePoint& from, const PlanePoint& to, bool clamped = false);
OutlinePiece arc(const PlanePoint& centre, double radius, double from, double turn, bool clamped = false);

}  // namespace contactd::fem

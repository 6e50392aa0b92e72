// Divides the outline of a section into the edges of a mesh.
#pragma once

#include <vector>

#include "outline.hpp"

namespace contactd::fem {

/// How fine a mesh is.
struct MeshDensity {
    int edges_a_strip = 4;
    double growth = 0.45;        ///< growth of element sizes with the distance from fine parts
    double edges_a_body = 10;    ///< of the largest extent
    double corner_share = 1e-3;  ///< size at a singular corner, divided by its distance from the strips
};

/// Runs from `from` to `to` (arc length along a piece), between the vertices `first` and `first + 1`, or between the
/// last vertex of a loop and its first one.
struct BoundaryEdge {
    std::size_t loop, piece;
    double from, to;
    int strip;  ///< its strip, or -1
    bool clamped;
    int first, second;  ///< vertices, numbered loop by loop with the body on the right
};

struct DividedOutline {
    std::vector<PlanePoint> vertices;
    std::vector<BoundaryEdge> edges;
    std::vector<int> loop_begin;  ///< first edge of each loop, and the number of edges
    double extent = 0;            ///< of the body
};

/// Strips are divided uniformly. Other edges grow with the distance from strips and from corners with singular
/// stresses: re-entrant corners, and the ends of clamped parts. No edge turns by more than a sixth of a right angle, or
/// is much longer than the body is thick there.
DividedOutline divide(const SectionOutline& outline, const MeshDensity& density);

/// Returns the size of elements at a point, which matches the nearby edges of the outline.
class SizeField {
   public:
    SizeField(const DividedOutline& outline, const MeshDensity& density);
    double operator()(const PlanePoint& at) const;

   private:
    struct Source {
        PlanePoint at;
        double size;
    };
    std::vector<Source> sources_;
    double growth_, largest_;
};

}  // namespace contactd::fem

// The outline of a section, divided into the edges of a mesh.
#pragma once

#include <vector>

#include "outline.hpp"

namespace contactd::fem {

/// How fine a mesh is.
struct MeshDensity {
    int edges_a_strip = 4;
    double growth = 0.45;        ///< of the size of elements with the distance from what is fine
    double edges_a_body = 10;    ///< of the largest extent
    double corner_share = 1e-3;  ///< size at a singular corner, over its distance from the strips
};

/// From `from` to `to` (arc length along a piece), between the vertices `first` and `first + 1`, the last of a loop
/// and its first one.
struct BoundaryEdge {
    std::size_t loop, piece;
    double from, to;
    int strip;  ///< that it belongs to, or -1
    bool clamped;
    int first, second;  ///< vertices, numbered from loop to loop with the body on the right
};

struct DividedOutline {
    std::vector<PlanePoint> vertices;
    std::vector<BoundaryEdge> edges;
    std::vector<int> loop_begin;  ///< first edge of each loop, and the number of edges
    double extent = 0;            ///< of the body
};

/// Strips are divided evenly, everything else grows with the distance from them, and from corners where stresses are
/// singular: re-entrant ones, and the ends of what is clamped. No edge turns by more than a sixth of a right angle, or
/// is much longer than the body is thick there.
DividedOutline divide(const SectionOutline& outline, const MeshDensity& density);

/// Size of elements at a point, as the edges of the outline are long there.
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

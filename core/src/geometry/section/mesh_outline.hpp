// The outline of a section as a mesher wants it: divided into edges, each along one smooth piece.
#pragma once

#include <vector>

#include "geometry/section/section_geometry.hpp"

namespace contactd::geometry {

/// How long edges shall be (docs/sections.md).
struct MeshSizes {
    int edges_per_column = 4;     ///< an even number: a vertex lies in the middle of every column
    double growth = 0.45;         ///< of an edge with the distance from the columns
    double corner_edge = 0.04;    ///< edges at re-entrant corners and at ends of held parts, over ds
    double corner_growth = 0.35;  ///< and how they grow with the distance from there
    double largest = 0.1;         ///< edge over the extent of the section
    double most_turn = 0.4;       ///< of the tangent along an edge (rad)
};

/// The edge from vertex i of a loop to the next one. Nodes between its ends lie at arc lengths between theirs.
struct OutlineEdge {
    SectionPoint at;   ///< of the vertex that it begins at
    double begin = 0;  ///< arc lengths on the curve, begin < end <= length
    double end = 0;
    bool held = false;
    int column = -1;  ///< the column that it is a part of, or -1
};

/// Edges of one closed curve in the order of travel, closed.
using OutlineLoop = std::vector<OutlineEdge>;

/// One loop a curve of `section.curves()`. Vertices lie at ends and midpoints of columns and wherever two pieces meet.
std::vector<OutlineLoop> mesh_outline(const SectionGeometry& section, const MeshSizes& sizes);

/// How long edges shall be inside the body, too.
class EdgeLengths {
   public:
    EdgeLengths(const SectionGeometry& section, const MeshSizes& sizes);
    double at(const SectionPoint& point) const;

   private:
    MeshSizes sizes_;
    double ds_, largest_;
    std::vector<SectionPoint> columns_;  ///< ends of the columns
    std::vector<SectionPoint> corners_;  ///< re-entrant ones, and ends of held parts
};

}  // namespace contactd::geometry

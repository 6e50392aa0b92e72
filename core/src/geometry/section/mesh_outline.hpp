// The outline of a section as a mesher wants it: divided into edges, each along one smooth piece.
#pragma once

#include <vector>

#include "geometry/section/edge_lengths.hpp"

namespace contactd::geometry {

/// An edge of the outline. Nodes between its ends lie at arc lengths between theirs.
struct OutlineEdge {
    SectionPoint at;   ///< of the vertex that it begins at; it ends at that of the edge behind it
    double begin = 0;  ///< arc lengths on the curve (mm), 0 <= begin < end <= length
    double end = 0;
    bool held = false;
    int column = -1;  ///< the column that it is a part of, or -1
};

/// Edges of one closed curve in the order of travel, closed.
using OutlineLoop = std::vector<OutlineEdge>;

/// One loop a curve of `section.curves()`. Vertices lie at ends and midpoints of columns and wherever two pieces meet.
std::vector<OutlineLoop> mesh_outline(const SectionGeometry& section, const MeshSizes& sizes);

}  // namespace contactd::geometry

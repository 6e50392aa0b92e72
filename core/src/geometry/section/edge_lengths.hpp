// How long the edges of a section's mesh shall be.
#pragma once

#include <vector>

#include "geometry/section/section_geometry.hpp"

namespace contactd::geometry {

/// How long edges shall be (docs/sections.md).
struct MeshSizes {
    int edges_per_column = 4;     ///< an even number: a vertex lies in the middle of every column
    double growth = 0.45;         ///< of an edge with its distance from the columns
    double corner_edge = 0.04;    ///< edges at re-entrant corners and at ends of held parts, over ds
    double corner_share = 3e-4;   ///< and no less than this share of the corner's distance from the columns
    double corner_growth = 0.35;  ///< growth with the distance from there
    double largest = 0.1;         ///< an edge over the extent of the section
    double most_turn = 0.4;       ///< of the tangent along an edge (rad)
};

/// How long edges shall be, at any point of the body.
class EdgeLengths {
   public:
    EdgeLengths(const SectionGeometry& section, const MeshSizes& sizes);
    double at(const SectionPoint& point) const;  ///< mm

   private:
    struct Corner {
        SectionPoint at;
        double edge;
    };
    void add_corner(const SectionPoint& at);
    double distance_from_columns(const SectionPoint& point) const;

    MeshSizes sizes_;
    double ds_, largest_;
    std::vector<SectionPoint> columns_;  // where they end
    std::vector<Corner> corners_;
};

}  // namespace contactd::geometry

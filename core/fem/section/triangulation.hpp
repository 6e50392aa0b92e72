// Triangles inside of a divided outline, by gmsh.
#pragma once

#include <array>
#include <vector>

#include "boundary_edges.hpp"

namespace contactd::fem {

struct Triangulation {
    std::vector<PlanePoint> vertices;           ///< those of the outline first, as numbered there
    std::vector<std::array<int, 3>> triangles;  ///< vertices anticlockwise in (y, z)
};

/// No vertex is added to the outline. Not for use by several threads. Throws InvalidArgument ("ics.section") when the
/// outline cannot be filled, Error when the module that has gmsh (mesher.hpp) is not there.
Triangulation triangulate(const DividedOutline& outline, const MeshDensity& density);

}  // namespace contactd::fem

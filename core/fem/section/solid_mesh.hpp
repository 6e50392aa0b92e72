// Makes a prism in three dimensions: the triangles of its cross-section, extruded along x as in the paper's Mesh2.
#pragma once

#include "boundary_edges.hpp"
#include "mesh/block_mesh.hpp"
#include "triangulation.hpp"

namespace contactd::fem {

/// Defines slices along x: as thick under the load as edges on strips are long, and growing behind it.
struct Slices {
    double growth = 1.4;  ///< growth from each slice to the next
    double length = 0;    ///< from the middle of the load to the clamped end of the body; divided by ds
};

/// Makes the half x <= 0 of a body whose section, of straight lines, is `divided` into `triangulation`, with a load of
/// length one on `strip`. As a BlockMesh requires, the body is seen from +x and +y: the middle of strip I is its
/// surface point (0, -I), so y runs against the section's. Lengths are divided by ds. Throws InvalidArgument
/// ("ics.section") unless strips lie side by side on a horizontal line.
BlockMesh make_solid_mesh(const SectionOutline& outline, const DividedOutline& divided,
                          const Triangulation& triangulation, int strip, const Slices& slices);

}  // namespace contactd::fem

// A prism in three dimensions: its cross-section's triangles, extruded along x as in the paper's Mesh2.
#pragma once

#include "boundary_edges.hpp"
#include "mesh/block_mesh.hpp"
#include "triangulation.hpp"

namespace contactd::fem {

/// Slices along x: as thick under the load as edges on strips are long, growing behind it.
struct Slices {
    double growth = 1.4;  ///< of each slice to the next one
    double length = 0;    ///< from the middle of the load to where the body ends, and is clamped; over ds
};

/// The half x <= 0 of a body whose section, of straight lines, is `divided` into `triangulation`, with a load one long
/// on `strip`. As a BlockMesh has it, the body is seen from +x and +y: the middle of strip I is its surface point
/// (0, -I), so that y runs against the section's. Lengths over ds. Throws InvalidArgument ("ics.section") where strips
/// do not lie side by side on a level line.
BlockMesh make_solid_mesh(const SectionOutline& outline, const DividedOutline& divided,
                          const Triangulation& triangulation, int strip, const Slices& slices);

}  // namespace contactd::fem

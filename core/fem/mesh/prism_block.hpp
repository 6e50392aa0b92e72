// Mesh2 of the paper (section 3.1): the quarter block in prisms whose triangles lie in the planes of constant x.
#pragma once

#include "block_mesh.hpp"

namespace contactd::fem {

/// The cross-section is the front of Mesh1, each quadrilateral cut by spec.fem.diagonal: m^2 + 2 m k of them. It is
/// extruded along x in m uniform slices through the cube and k growing ones: 2 (m^2 + 2 m k) (m + k) wedges, numbered
/// slice by slice from x = 0 and in a slice from the edge y = z = 0 outwards. All their maps are affine. Reference
/// axes: the triangles' in (x, y), the extrusion in z, which runs from x = 0 to x = -L. `spec` must be dimensionless
/// and valid.
BlockMesh make_prism_block(const IcSpec& spec);

}  // namespace contactd::fem

// Makes Mesh2 of the paper (section 3.1): the quarter block in prisms whose triangles lie in planes of constant x.
#pragma once

#include "block_mesh.hpp"

namespace contactd::fem {

/// The cross-section is the front of Mesh1, with each of its m^2 + 2 m k quadrilaterals divided along
/// spec.fem.diagonal. It is extruded along x in m uniform slices through the cube and k growing ones. The 2 (m^2 + 2 m
/// k) (m + k) wedges are numbered slice by slice from x = 0, and in a slice from the edge y = z = 0 outwards. All
/// element maps are affine. Of the reference axes, x and y span the triangles, and z is the extrusion, from x = 0 to x
/// = -L. `spec` must be dimensionless and valid.
BlockMesh make_prism_block(const IcSpec& spec);

}  // namespace contactd::fem

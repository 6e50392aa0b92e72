// Tables on meshes that are refined where an a-posteriori estimate of the error asks for it.
#pragma once

#include "mesh_build.hpp"
#include "mesh/refined_block.hpp"

namespace contactd::fem {

/// The coarsest Mesh1: the quarter of the load is one element, and layers of three double its size until L. Of
/// `spec.fem` only the size of the block counts.
BlockMesh make_start_mesh(const IcSpec& spec);

/// Refines the start mesh, one mesh for all loads, until spec.fem.max_dofs leaves no room, and builds the table on the
/// last mesh. `spec` is dimensionless, of mesh adaptive. Of the evidence the load cases are those of the last mesh,
/// times those of all. `comm` is of one process. Throws InvalidArgument when the start mesh exceeds max_dofs;
/// NotConverged when a load case misses its tolerance.
IcRecord build_adaptive(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress);

}  // namespace contactd::fem

// Builds tables on meshes that are refined by an a-posteriori error estimate.
#pragma once

#include "mesh/refined_block.hpp"
#include "mesh_build.hpp"

namespace contactd::fem {

/// Returns the coarsest Mesh1: the quarter of the load is one element, and layers of three double its size until L. Of
/// `spec.fem`, it uses only the size of the block.
BlockMesh make_start_mesh(const IcSpec& spec);

/// Refines the start mesh, one mesh for all loads, until spec.fem.max_dofs leaves no room, and builds the table on the
/// last mesh. `spec` is dimensionless, with an adaptive mesh. The load cases of the evidence are those of the last
/// mesh, and its times include all meshes. `comm` has one process. Throws InvalidArgument if the start mesh exceeds
/// max_dofs, and NotConverged if a load case misses its tolerance.
IcRecord build_adaptive(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress);

}  // namespace contactd::fem

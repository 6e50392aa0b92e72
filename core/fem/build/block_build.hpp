// Builds a block table to a requested accuracy as a half-space solution plus a correction
// (tensor/block_correction.hpp): u = closed form + w. The closed form contains the load's singularities.
#pragma once

#include "mesh_build.hpp"
#include "tensor/block_correction.hpp"

namespace contactd::fem {

/// Uses one process. `spec` is dimensionless, for a block, with accuracy > 0 and one Poisson's ratio. Meshes become
/// finer, in order and in number, until two successive tables agree. The errors of the evidence are estimates: half of
/// the difference from the table of the previous mesh. Throws NotConverged if no available mesh reaches the accuracy.
IcRecord build_block(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress);

/// Returns the finer one of the first two meshes.
BlockLevel first_block_level();

}  // namespace contactd::fem

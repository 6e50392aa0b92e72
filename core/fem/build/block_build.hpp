// The block of an accuracy asked for, as the half-space and a correction (tensor/block_correction.hpp): u = closed form
// + w. The load's singularities are in the closed form.
#pragma once

#include "mesh_build.hpp"
#include "tensor/block_correction.hpp"

namespace contactd::fem {

/// One process. `spec` is dimensionless, body block, with accuracy > 0, for one Poisson's ratio. Meshes become finer,
/// in order and in number, until two tables in succession agree. The errors of the evidence are estimated: half of the
/// difference to the table of the mesh before. Throws NotConverged when no mesh at hand reaches the accuracy.
IcRecord build_block(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress);

/// The finer one of the first two meshes.
BlockLevel first_block_level();

}  // namespace contactd::fem

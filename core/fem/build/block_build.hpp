// The block of an accuracy asked for, as the half-space and a correction: u = closed form + w. The load's singularities
// are in the closed form; w, which undoes the half-space's displacements on the clamped faces, is smooth but for the
// edges where these meet the free surface.
#pragma once

#include "mesh_build.hpp"

namespace contactd::fem {

/// Collective. `spec` is dimensionless, body block, with accuracy > 0, for one Poisson's ratio. The errors of the
/// evidence are estimated: a third of the difference to the table of the next lower order. Throws NotConverged when
/// no mesh at hand reaches the accuracy.
IcRecord build_block(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress);

/// A mesh that is tried: order of its elements, and their number along each axis.
struct BlockLevel {
    int order;
    int intervals;
};
BlockLevel first_block_level();

}  // namespace contactd::fem

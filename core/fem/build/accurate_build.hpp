// Tables of an accuracy asked for: mesh, order, far boundary and solver are chosen here.
#pragma once

#include "mesh_build.hpp"

namespace contactd::fem {

/// Collective. `spec` is dimensionless with accuracy > 0, for one Poisson's ratio. The record's spec holds the mesh
/// that was chosen, which would do for Poisson's ratios up to `hardest_nu` as well: tables that are interpolated
/// between need one mesh. Throws NotConverged when no mesh at hand reaches the accuracy.
IcRecord build_accurate(MPI_Comm comm, const IcSpec& spec, double hardest_nu, const ProgressPart& progress);

/// The spec with the mesh that build_accurate() starts with, of a half-space.
IcSpec first_mesh(const IcSpec& spec, double hardest_nu);

/// The largest of the errors in the measures of IcSpec::accuracy.
double largest_error(const IcEvidence& evidence);

[[noreturn]] void throw_not_reached(double accuracy, double error);

}  // namespace contactd::fem

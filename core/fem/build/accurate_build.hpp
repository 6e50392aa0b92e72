// Builds tables to a requested accuracy, and chooses mesh, order, far boundary and solver.
#pragma once

#include "mesh_build.hpp"

namespace contactd::fem {

/// Collective. `spec` is dimensionless with accuracy > 0, for one Poisson's ratio. The record's spec contains the
/// chosen mesh, which also suffices for Poisson's ratios up to `hardest_nu`, because interpolation between tables
/// requires one mesh. Throws NotConverged if no available mesh reaches the accuracy.
IcRecord build_accurate(MPI_Comm comm, const IcSpec& spec, double hardest_nu, const ProgressPart& progress);

/// Returns the spec with the mesh of a half-space that build_accurate() starts with.
IcSpec first_mesh(const IcSpec& spec, double hardest_nu);

/// Returns the largest of the errors in the measures of IcSpec::accuracy.
double largest_error(const IcEvidence& evidence);

[[noreturn]] void throw_not_reached(double accuracy, double error);

}  // namespace contactd::fem

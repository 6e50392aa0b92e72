// Tables of an accuracy asked for: mesh, order, far boundary and solver are chosen here.
#pragma once

#include "mesh_build.hpp"

namespace contactd::fem {

/// Collective. `spec` is dimensionless with accuracy > 0, for one Poisson's ratio. The record's spec holds the mesh
/// that was chosen. Throws NotConverged when no mesh at hand reaches the accuracy.
IcRecord build_accurate(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress);

/// The largest of the errors in the measures of IcSpec::accuracy.
double largest_error(const IcEvidence& evidence);

[[noreturn]] void throw_not_reached(double accuracy, double error);

}  // namespace contactd::fem

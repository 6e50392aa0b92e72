// The family of tables over Poisson's ratio (ic_family.hpp).
#pragma once

#include "mesh_build.hpp"

namespace contactd::fem {

/// Builds the table of one Poisson's ratio on a mesh that does for all up to `hardest_nu`.
using BuildOne = std::function<IcRecord(const IcSpec& spec, double hardest_nu, const ProgressPart& progress)>;

/// Collective. `spec` is dimensionless with any_nu set. Adds points until interpolation between them adds less than a
/// twentieth of the accuracy asked for or, where a mesh is given, than a tenth of its error under the load in the same
/// half of Poisson's ratios (but no less than 1e-5); throws NotConverged when it does not come to that. The evidence's
/// errors are the largest of all tables, its times their sum.
IcRecord build_family(MPI_Comm comm, const IcSpec& spec, const BuildOne& build_one, const ProgressPart& progress);

}  // namespace contactd::fem

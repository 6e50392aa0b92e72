// Builds the family of tables over Poisson's ratio (ic_family.hpp).
#pragma once

#include "mesh_build.hpp"

namespace contactd::fem {

/// Builds the table of one Poisson's ratio on a mesh that suffices for all up to `hardest_nu`.
using BuildOne = std::function<IcRecord(const IcSpec& spec, double hardest_nu, const ProgressPart& progress)>;

/// Collective. `spec` is dimensionless with any_nu set. Adds points until interpolation between them adds less than a
/// twentieth of the requested accuracy. With a given mesh the limit is a tenth of its error under the load in the same
/// half of Poisson's ratios, but at least 1e-5. Throws NotConverged if this limit is not reached. The evidence contains
/// the largest errors of all tables and the sum of their times.
IcRecord build_family(MPI_Comm comm, const IcSpec& spec, const BuildOne& build_one, const ProgressPart& progress);

}  // namespace contactd::fem

// Estimates how far a block deviates from the assumption of its table, that its response is the same for every element.
#pragma once

#include "mesh_build.hpp"

namespace contactd::fem {

/// The table of a block is that of a load in the middle of its top. Here, the load is on the corner element of spec.nx
/// x spec.ny elements about the middle, and displacements are observed at all of them. Returns 1.1 times the largest
/// difference from the table, in the measures of IcSpec::accuracy, which bounds that of loads on all elements. Both
/// loads are solved on one mesh of a hundred elements, independent of the table's mesh, because two digits are
/// sufficient. `spec` is dimensionless, for one Poisson's ratio.
double modelling_error(const IcSpec& spec, const ProgressPart& progress);

}  // namespace contactd::fem

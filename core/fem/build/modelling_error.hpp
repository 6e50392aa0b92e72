// How far a block is from what its table takes it for: a body that looks the same from every element.
#pragma once

#include "mesh_build.hpp"

namespace contactd::fem {

/// The table of a block is that of a load in the middle of its top. Here the element in the corner of spec.nx x spec.ny
/// elements about the middle is loaded, and observed at all of them. Returns a tenth more than the largest difference to
/// the table, in the measures of IcSpec::accuracy, which bounds that of loads on all elements. Both loads are solved on
/// one mesh of a hundred elements, whatever mesh the table is from: two digits are enough.
/// `spec` is dimensionless, for one Poisson's ratio.
double modelling_error(const IcSpec& spec, const ProgressPart& progress);

}  // namespace contactd::fem

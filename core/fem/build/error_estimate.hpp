// Which elements limit the accuracy of a table, estimated from the displacements computed on a mesh.
#pragma once

#include <vector>

#include "mesh_build.hpp"

namespace contactd::fem {

/// Returns the estimated error of each element in the energy norm, over all loads: the difference between the stresses
/// of its own displacements and those averaged at the nodes (Zienkiewicz and Zhu, Int. J. Num. Meth. Engng. 33,
/// 1331-1382, 1992).
std::vector<double> energy_errors(ElasticityProblem& problem, const std::vector<Solution>& solutions);

/// Returns how much an error in the energy norm of each element counts in the table's relative errors, up to a common
/// factor. The error of the displacement at an offset is bounded by the products of the elements' errors for the load
/// and for a load at that offset (Becker and Rannacher, Acta Numerica 10, 1-102, 2001). The latter is not computed:
/// displacements under a point load fall as 1/d, and so elements of order p and size H interpolate them with an error
/// of H^(p+3/2) / d^(p+2). This is divided by the displacement, which falls as 1/rho, and taken for the offset where it
/// is largest.
std::vector<double> table_weights(ElasticityProblem& problem);

}  // namespace contactd::fem

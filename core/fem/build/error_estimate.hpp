// Estimates which elements limit the accuracy of a table, from the displacements computed on a mesh.
#pragma once

#include <vector>

#include "mesh_build.hpp"

namespace contactd::fem {

/// Returns the estimated error of each element in the energy norm, over all loads. It is the difference between the
/// element's own stresses and those averaged at the nodes (Zienkiewicz and Zhu, Int. J. Num. Meth. Engng. 33,
/// 1331-1382, 1992).
std::vector<double> energy_errors(ElasticityProblem& problem, const std::vector<Solution>& solutions);

/// Returns the weight of each element's error in the energy norm in the table's relative errors, up to a common factor.
/// The error of the displacement at an offset is bounded by the products of the elements' errors for the load and for a
/// load at that offset (Becker and Rannacher, Acta Numerica 10, 1-102, 2001). The latter is not computed: displacements
/// under a point load decrease as 1/d, so elements of order p and size H interpolate them with an error of H^(p+3/2) /
/// d^(p+2). This is divided by the displacement, which decreases as 1/rho, and evaluated at the offset where it is
/// largest.
std::vector<double> table_weights(ElasticityProblem& problem);

}  // namespace contactd::fem

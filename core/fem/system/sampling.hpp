// Reads influence coefficients from finite-element displacements.
#pragma once

#include <vector>

#include "contactd/ic_table.hpp"
#include "elasticity_problem.hpp"

namespace contactd::fem {

/// Holds a solved load case, and the direction it is read for. `load` differs from `solved` if one represents the other
/// mirrored on the plane x = y.
struct SolvedCase {
    Axis solved;
    Axis load;
    const mfem::Vector* true_dofs;
};

/// Collective. Returns the table of `spec`, the same for any number of processes, because each value is read by the
/// process that has its element. Directions without a case remain zero.
IcTable sample_table(ElasticityProblem& problem, const IcSpec& spec, const std::vector<SolvedCase>& cases);

}  // namespace contactd::fem

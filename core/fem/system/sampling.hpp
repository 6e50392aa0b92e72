// Reading influence coefficients off finite-element displacements.
#pragma once

#include <vector>

#include "contactd/ic_table.hpp"
#include "elasticity_problem.hpp"

namespace contactd::fem {

/// A solved load case, and the direction it is read for: `load` differs from `solved` when one stands for the other
/// mirrored on the plane x = y.
struct SolvedCase {
    Axis solved;
    Axis load;
    const mfem::Vector* true_dofs;
};

/// Collective. The table of `spec`, the same on every process whatever their number: a value is read by the one
/// process that has its element. Directions without a case stay zero.
IcTable sample_table(ElasticityProblem& problem, const IcSpec& spec, const std::vector<SolvedCase>& cases);

}  // namespace contactd::fem

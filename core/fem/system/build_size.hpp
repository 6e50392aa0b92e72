// Predicts the cost of a build by the formulas of its mesh, before anything is built.
#pragma once

#include <cstdint>

#include "contactd/ic_spec.hpp"

namespace contactd::fem {

struct BuildSize {
    long long dofs = 0;
    Solver solver = Solver::amg_pcg;
    double bytes = 0;  ///< largest resident memory, of all processes together
};

/// `spec` is dimensionless. An accuracy is taken to be met by the mesh that is tried first, an adaptive mesh to fill
/// max_dofs, and a family is as large as its largest member and all its tables. Against what was measured on meshes of
/// all kinds, orders and solvers, memory came out within a factor of 1.5, of sections between 1.05 and 1.3 times
/// (tests/core/fem/test_build_size.cpp).
BuildSize predicted_size(const IcSpec& spec, int processes);

/// Throws OutOfMemory, which names what to change, when `size` is certainly more than `max_memory_bytes`; 0: no limit.
void require_room(const IcSpec& spec, const BuildSize& size, std::uint64_t max_memory_bytes);

/// Entries in a row of the stiffness matrix, on average.
double nonzeros_per_dof(const FemSpec& fem);

/// spec.fem.solver with `automatic` replaced by what was measured to be faster (bench/bench_fem.cpp): Cholesky on one
/// process, as long as the factor fits into a few gigabytes.
Solver solver_for(const FemSpec& fem, long long dofs, int processes);

}  // namespace contactd::fem

// Predicts the cost of a build by the formulas of its mesh, before anything is built.
#pragma once

#include <cstdint>

#include "contactd/ic_spec.hpp"

namespace contactd::fem {

struct BuildSize {
    long long dofs = 0;
    Solver solver = Solver::amg_pcg;
    double bytes = 0;  ///< largest resident memory of all processes together
};

/// `spec` is dimensionless. The prediction assumes that the first mesh meets an accuracy, that an adaptive mesh fills
/// max_dofs, and that a family needs the memory of its largest member and of all its tables. Compared with measurements
/// on meshes of all kinds, orders and solvers, predicted memory was within a factor of 1.5; for sections it was 1.05 to
/// 1.3 times as large (tests/core/fem/test_build_size.cpp).
BuildSize predicted_size(const IcSpec& spec, int processes);

/// Throws OutOfMemory, naming the field to change, if `size` certainly exceeds `max_memory_bytes`; 0: no limit.
void require_room(const IcSpec& spec, const BuildSize& size, std::uint64_t max_memory_bytes);

/// Returns the average number of entries in a row of the stiffness matrix.
double nonzeros_per_dof(const FemSpec& fem);

/// Returns spec.fem.solver, with `automatic` replaced by the solver that was faster in measurements
/// (bench/bench_fem.cpp): Cholesky on one process, as long as the factor fits into a few gigabytes.
Solver solver_for(const FemSpec& fem, long long dofs, int processes);

}  // namespace contactd::fem

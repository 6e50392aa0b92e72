// The system of equations of a problem, assembled once and solved for each load case.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "elasticity_problem.hpp"

namespace contactd::fem {

struct SolveResult {
    int iterations = 0;   ///< of conjugate gradients; 0 with a direct solver
    double residual = 0;  ///< true relative residual, computed from the solution, ||b - A w|| / ||b|| where w is what
                          ///< is sought beyond the given displacements
    std::optional<double> update;  ///< of the last iteration, when the stop test asks for it
    bool converged = false;
    double setup_seconds = 0;
    double solve_seconds = 0;
};

/// Called after the setup with iteration 0 and then after each iteration, on all processes, with the figure of the stop
/// test.
using SolveMonitor = std::function<void(int iteration, double figure)>;

/// Called with the fraction assembled, at the same points on all processes.
using AssemblyMonitor = std::function<void(double fraction)>;

inline double seconds_since(double start) {
    return MPI_Wtime() - start;
}

class LinearSystem {
   public:
    virtual ~LinearSystem() = default;
    /// Collective. `u`: true degrees of freedom, those given included. Of a system that eliminates nodes inside
    /// elements (`direct`) their displacements stay zero; nothing on the surface depends on them.
    virtual SolveResult solve(const LoadCase& load_case, mfem::Vector& u, const SolveMonitor& monitor) = 0;
};

/// spec.fem.solver with `automatic` replaced by what was measured to be faster (bench/bench_fem.cpp): Cholesky on one
/// process, as long as the factor fits into a few gigabytes. Throws InvalidArgument when a direct solver is asked for
/// where there can be none.
Solver chosen_solver(const ElasticityProblem& problem);

/// Collective. Assembles the system of chosen_solver(problem). `problem` must outlive it.
std::unique_ptr<LinearSystem> make_linear_system(ElasticityProblem& problem, const AssemblyMonitor& monitor);

}  // namespace contactd::fem

// Assembles the system of equations of a problem once, and solves it for each load case.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "elasticity_problem.hpp"

namespace contactd::fem {

struct SolveResult {
    int iterations = 0;   ///< iterations of conjugate gradients; 0 with a direct solver
    double residual = 0;  ///< true relative residual of the solution, ||b - A w|| / ||b||, where w is the unknown
                          ///< part beyond the prescribed displacements
    std::optional<double> update;  ///< relative update of the last iteration, if it is the stopping criterion
    bool converged = false;
    double setup_seconds = 0;
    double solve_seconds = 0;
};

/// Each is called at the same points on all processes.
struct SolveMonitor {
    /// Called when a step of the setup begins, with its expected time, and that of the whole solve if it is known.
    std::function<void(double seconds, std::optional<double> whole)> setup;
    /// Called after the setup with iteration 0, and then after each iteration, with the value of the stopping criterion
    /// and the expected time of the next iteration.
    std::function<void(int iteration, double figure, double seconds)> iteration;
};

/// Called with the fraction assembled and the time (s) expected until the next call, at the same points on all
/// processes.
using AssemblyMonitor = std::function<void(double fraction, double seconds)>;

inline double seconds_since(double start) {
    return MPI_Wtime() - start;
}

class LinearSystem {
   public:
    virtual ~LinearSystem() = default;
    /// Collective. `u` contains true degrees of freedom, including the prescribed ones. If the system eliminates nodes
    /// inside elements (`direct`), their displacements remain zero, because nothing on the surface depends on them.
    virtual SolveResult solve(const LoadCase& load_case, mfem::Vector& u, const SolveMonitor& monitor) = 0;
};

/// Returns solver_for() the problem (build_size.hpp). Throws InvalidArgument if a direct solver is requested where none
/// is possible.
Solver chosen_solver(const ElasticityProblem& problem);

/// Collective. Assembles the system of chosen_solver(problem). `problem` must outlive it.
std::unique_ptr<LinearSystem> make_linear_system(ElasticityProblem& problem, const AssemblyMonitor& monitor);

}  // namespace contactd::fem

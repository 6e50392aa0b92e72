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
    std::optional<double> update;  ///< of the last iteration, when the stopping criterion asks for it
    bool converged = false;
    double setup_seconds = 0;
    double solve_seconds = 0;
};

/// Each is called at the same points on all processes.
struct SolveMonitor {
    /// A step of the setup begins: the time it is expected to take, and that of the whole solve where it is known.
    std::function<void(double seconds, std::optional<double> whole)> setup;
    /// After the setup with iteration 0 and then after each iteration, with the figure of the stopping criterion and
    /// what the next iteration is expected to take.
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
    /// Collective. `u`: true degrees of freedom, those given included. Of a system that eliminates nodes inside
    /// elements (`direct`) their displacements stay zero; nothing on the surface depends on them.
    virtual SolveResult solve(const LoadCase& load_case, mfem::Vector& u, const SolveMonitor& monitor) = 0;
};

/// solver_for() the problem (build_size.hpp). Throws InvalidArgument when a direct solver is asked for where there can
/// be none.
Solver chosen_solver(const ElasticityProblem& problem);

/// Collective. Assembles the system of chosen_solver(problem). `problem` must outlive it.
std::unique_ptr<LinearSystem> make_linear_system(ElasticityProblem& problem, const AssemblyMonitor& monitor);

}  // namespace contactd::fem

// Solves by sparse Cholesky factorisation (CHOLMOD, supernodal) on one process. Nodes inside elements are first
// eliminated element by element, which saves entries; no surface point needs them.
#pragma once

#include <Eigen/SparseCore>

#include "linear_system.hpp"

namespace contactd::fem {

class CholeskySystem final : public LinearSystem {
   public:
    /// Throws InvalidArgument on more than one process.
    CholeskySystem(ElasticityProblem& problem, const AssemblyMonitor& monitor);
    SolveResult solve(const LoadCase& load_case, mfem::Vector& u, const SolveMonitor& monitor) override;

   private:
    using Matrix = Eigen::SparseMatrix<double>;

    Matrix free_part(const std::vector<int>& free_number, Eigen::Index count) const;

    double factorisation_rate();

    double tolerance_;
    double rate_ = 0;          ///< floating-point operations per second of the last factorisation
    std::vector<int> number_;  ///< number in the matrix of each node of the space, -1 inside elements
    Matrix lower_;             ///< lower half, three rows per numbered node, without constraints
};

}  // namespace contactd::fem

// Solves by conjugate gradients preconditioned by BoomerAMG.
#pragma once

#include "linear_system.hpp"

namespace contactd::fem {

class AmgSystem final : public LinearSystem {
   public:
    AmgSystem(ElasticityProblem& problem, const AssemblyMonitor& monitor);
    SolveResult solve(const LoadCase& load_case, mfem::Vector& u, const SolveMonitor& monitor) override;

   private:
    const FemSpec& fem_;
    const int processes_;
    double nonzeros_ = 0;
    std::unique_ptr<mfem::HypreParMatrix> unconstrained_;
};

/// Returns BoomerAMG's strength threshold if the spec does not set it, chosen by measured iterations and seconds for
/// each kind of mesh.
double default_strength_threshold(MeshKind mesh);

}  // namespace contactd::fem

// Conjugate gradients preconditioned by BoomerAMG.
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

/// BoomerAMG's strength threshold when the spec leaves it to us, by the iterations and seconds measured for each kind
/// of mesh.
double default_strength_threshold(MeshKind mesh);

}  // namespace contactd::fem

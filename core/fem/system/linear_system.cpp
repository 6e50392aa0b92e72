#include "linear_system.hpp"

#include "amg_system.hpp"
#include "build_size.hpp"
#include "cholesky_system.hpp"
#include "contactd/error.hpp"

namespace contactd::fem {

Solver chosen_solver(const ElasticityProblem& problem) {
    const FemSpec& fem = problem.spec().fem;
    if (fem.solver == Solver::direct && (problem.processes() > 1 || fem.mesh == MeshKind::adaptive))
        throw InvalidArgument(
            "ics.solver",
            "is direct, which requires a single process and a mesh without hanging nodes; use amg_pcg or auto");
    return solver_for(fem, problem.dofs(), problem.processes());
}

std::unique_ptr<LinearSystem> make_linear_system(ElasticityProblem& problem, const AssemblyMonitor& monitor) {
    if (chosen_solver(problem) == Solver::direct) return std::make_unique<CholeskySystem>(problem, monitor);
    return std::make_unique<AmgSystem>(problem, monitor);
}

}  // namespace contactd::fem

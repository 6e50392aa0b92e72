#include "linear_system.hpp"

#include "amg_system.hpp"
#include "cholesky_system.hpp"
#include "contactd/error.hpp"

namespace contactd::fem {

namespace {

/// Up to here the factor was built faster than BoomerAMG converged; at the end it takes 5 GB. Elements of higher order
/// have denser rows, with which BoomerAMG fares far worse than a factor.
long long direct_dofs(int order) {
    return order <= 2 ? 150'000 : 250'000;
}

}  // namespace

Solver chosen_solver(const ElasticityProblem& problem) {
    const FemSpec& fem = problem.spec().fem;
    // Hanging nodes tie degrees of freedom together, which only the distributed matrix knows of.
    const bool possible = problem.processes() == 1 && fem.mesh != MeshKind::adaptive;
    if (fem.solver == Solver::direct && !possible)
        throw InvalidArgument("ics.solver",
                              "is direct, which needs one process and a mesh without hanging nodes; take "
                              "amg_pcg, or auto");
    if (fem.solver != Solver::automatic) return fem.solver;
    // The update is a stop test of iterations.
    if (fem.stop_test == StopTest::update) return Solver::amg_pcg;
    return possible && problem.dofs() <= direct_dofs(fem.order) ? Solver::direct : Solver::amg_pcg;
}

std::unique_ptr<LinearSystem> make_linear_system(ElasticityProblem& problem, const AssemblyMonitor& monitor) {
    if (chosen_solver(problem) == Solver::direct) return std::make_unique<CholeskySystem>(problem, monitor);
    return std::make_unique<AmgSystem>(problem, monitor);
}

}  // namespace contactd::fem

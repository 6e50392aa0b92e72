#include "amg_system.hpp"

#include <cmath>

#include "build_size.hpp"
#include "element_stiffness.hpp"

namespace contactd::fem {
namespace {

/// The recurrence's residual drifts from the true one. Whenever it indicates convergence, the true residual is
/// computed, and CG restarts from there if they disagree. After this many restarts without progress, the true residual
/// is limited by rounding.
constexpr int futile_restarts = 3;

/// BoomerAMG's setup takes about this time, and so does the assembly of the matrix.
constexpr double seconds_per_nonzero = 2e-7;

struct Iteration {
    const mfem::HypreParMatrix& A;
    const mfem::HypreBoomerAMG& preconditioner;
    const mfem::Vector& b;
    mfem::Vector& x;
    const FemSpec& settings;
    const SolveMonitor& monitor;
    MPI_Comm comm = A.GetComm();
    double norm_b = norm(b);
    mfem::Vector r{b.Size()}, z{b.Size()}, d{b.Size()}, q{b.Size()};

    double norm(const mfem::Vector& v) const { return std::sqrt(mfem::InnerProduct(comm, v, v)); }
    double relative_norm_of_r() const { return norm(r) / norm_b; }

    double true_residual() {
        A.Mult(x, r);
        subtract(b, r, r);
        return relative_norm_of_r();
    }

    /// Runs conjugate gradients from the residual in r; returns the recurrence's last relative residual.
    double run_to_residual(int& iterations) {
        double residual = relative_norm_of_r();
        double rz = 0;
        while (residual > settings.tolerance && iterations < settings.max_iterations) {
            const double start = MPI_Wtime();
            if (!step(rz)) break;
            residual = relative_norm_of_r();
            monitor.iteration(++iterations, residual, seconds_since(start));
        }
        return residual;
    }

    /// Iterates until the update is small compared with the iterate; returns the last relative update.
    double run_to_update(int& iterations) {
        double update = 1, rz = 0;
        while (update > settings.tolerance && iterations < settings.max_iterations) {
            const double start = MPI_Wtime();
            const auto length = step(rz);
            if (!length) break;
            update = *length / norm(x);
            monitor.iteration(++iterations, update, seconds_since(start));
        }
        return update;
    }

    /// Runs one iteration. Returns the length of the update, or nothing if rounding prevents further progress.
    std::optional<double> step(double& rz) {
        z = 0.0;
        preconditioner.Mult(r, z);
        const double rz_new = mfem::InnerProduct(comm, r, z);
        if (rz == 0)
            d = z;
        else
            add(z, rz_new / rz, d, d);
        rz = rz_new;
        A.Mult(d, q);
        const double curvature = mfem::InnerProduct(comm, d, q);
        if (!(curvature > 0 && rz > 0)) return std::nullopt;  // lost to rounding, or not a number
        const double alpha = rz / curvature;
        x.Add(alpha, d);
        r.Add(-alpha, q);
        return std::abs(alpha) * norm(d);
    }
};

SolveResult solve_to_residual(Iteration& iteration) {
    SolveResult result;
    const double tolerance = iteration.settings.tolerance;
    result.residual = iteration.true_residual();
    for (int futile = 0; result.residual > tolerance && futile < futile_restarts;) {
        const double claimed = iteration.run_to_residual(result.iterations);
        const double reached = iteration.true_residual();
        futile = reached < 0.5 * result.residual ? 0 : futile + 1;
        result.residual = reached;
        if (!(claimed <= tolerance)) break;  // out of iterations or broken down
    }
    result.converged = result.residual <= tolerance;
    return result;
}

SolveResult solve_to_update(Iteration& iteration) {
    SolveResult result;
    iteration.true_residual();
    result.update = iteration.run_to_update(result.iterations);
    result.converged = *result.update <= iteration.settings.tolerance;
    result.residual = iteration.true_residual();
    return result;
}

}  // namespace

double default_strength_threshold(MeshKind mesh) {
    return mesh == MeshKind::prism ? 0.8 : 0.5;
}

AmgSystem::AmgSystem(ElasticityProblem& problem, const AssemblyMonitor& monitor)
    : fem_(problem.spec().fem), processes_(problem.processes()) {
    mfem::ParFiniteElementSpace& space = problem.space();
    mfem::ParBilinearForm form(&space);
    mfem::Array<int> vdofs;
    const auto visit = [&](int element, Eigen::MatrixXd stiffness) {  // a copy, because MFEM requires write access
        const auto size = static_cast<int>(stiffness.rows());
        form.AssembleElementMatrix(element, mfem::DenseMatrix(stiffness.data(), size, size), vdofs);
    };
    for_each_stiffness(space, problem.spec().material, visit, monitor);
    const double entries = nonzeros_per_dof(problem.spec().fem) * static_cast<double>(problem.dofs());
    monitor(1, seconds_per_nonzero * entries / problem.processes());
    form.Finalize();
    unconstrained_.reset(form.ParallelAssemble());
    nonzeros_ = static_cast<double>(unconstrained_->NNZ());
}

SolveResult AmgSystem::solve(const LoadCase& load_case, mfem::Vector& u, const SolveMonitor& monitor) {
    double start = MPI_Wtime();
    monitor.setup(seconds_per_nonzero * nonzeros_ / processes_, std::nullopt);
    // Uses u = given + w, where w vanishes at prescribed displacements.
    mfem::Vector b = load_case.forces;
    unconstrained_->Mult(-1, load_case.given, 1, b);
    b.SetSubVector(load_case.essential, 0.0);
    mfem::HypreParMatrix A(*unconstrained_);
    A.EliminateBC(load_case.essential, mfem::Operator::DIAG_KEEP);

    mfem::HypreBoomerAMG preconditioner(A);
    preconditioner.SetSystemsOptions(3);
    preconditioner.SetStrengthThresh(fem_.strength_threshold.value_or(default_strength_threshold(fem_.mesh)));
    preconditioner.SetPrintLevel(0);
    mfem::Vector w(b.Size());
    w = 0.0;
    preconditioner.Setup(b, w);
    const double setup = seconds_since(start);

    start = MPI_Wtime();
    monitor.iteration(0, 1, setup);
    Iteration iteration{A, preconditioner, b, w, fem_, monitor};
    SolveResult result = fem_.stopping_criterion == StoppingCriterion::update ? solve_to_update(iteration)
                                                                              : solve_to_residual(iteration);
    u = load_case.given;
    u += w;
    result.setup_seconds = setup;
    result.solve_seconds = seconds_since(start);
    return result;
}

}  // namespace contactd::fem

#include "amg_pcg.hpp"

#include <cmath>

namespace contactd::fem {
namespace {

double seconds_since(double start) {
    return MPI_Wtime() - start;
}

/// The recurrence's residual drifts from the true one; each time it says "converged" the true one is computed, and CG
/// starts again from there when it disagrees. After this many restarts without progress the true residual stands at
/// rounding.
constexpr int futile_restarts = 3;

struct Iteration {
    const mfem::HypreParMatrix& A;
    const mfem::HypreBoomerAMG& preconditioner;
    const mfem::Vector& b;
    mfem::Vector& x;
    const PcgSettings& settings;
    const PcgMonitor& monitor;
    MPI_Comm comm = A.GetComm();
    double norm_b = std::sqrt(mfem::InnerProduct(comm, b, b));
    mfem::Vector r{b.Size()}, z{b.Size()}, d{b.Size()}, q{b.Size()};

    double relative_norm_of_r() const { return std::sqrt(mfem::InnerProduct(comm, r, r)) / norm_b; }

    double true_residual() {
        A.Mult(x, r);
        subtract(b, r, r);
        return relative_norm_of_r();
    }

    /// Conjugate gradients from the residual in r; returns the recurrence's last relative residual.
    double run(int& iterations) {
        double residual = relative_norm_of_r();
        double rz = 0;
        while (residual > settings.tolerance && iterations < settings.max_iterations) {
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
            if (!(curvature > 0 && rz > 0)) break;  // lost to rounding, or not a number
            const double alpha = rz / curvature;
            x.Add(alpha, d);
            r.Add(-alpha, q);
            residual = relative_norm_of_r();
            monitor(++iterations, residual);
        }
        return residual;
    }
};

}  // namespace

PcgResult solve_amg_pcg(const mfem::HypreParMatrix& A, const mfem::Vector& b, mfem::Vector& x,
                        const PcgSettings& settings, const PcgMonitor& monitor) {
    PcgResult result;
    double start = MPI_Wtime();
    mfem::HypreBoomerAMG preconditioner(A);
    preconditioner.SetSystemsOptions(3);
    preconditioner.SetStrengthThresh(settings.strength_threshold);
    preconditioner.SetPrintLevel(0);
    x.SetSize(b.Size());
    x = 0.0;
    preconditioner.Setup(b, x);
    result.setup_seconds = seconds_since(start);

    start = MPI_Wtime();
    monitor(0, 1);
    Iteration iteration{A, preconditioner, b, x, settings, monitor};
    result.residual = iteration.true_residual();
    for (int futile = 0; result.residual > settings.tolerance && futile < futile_restarts;) {
        const double claimed = iteration.run(result.iterations);
        const double reached = iteration.true_residual();
        futile = reached < 0.5 * result.residual ? 0 : futile + 1;
        result.residual = reached;
        if (!(claimed <= settings.tolerance)) break;  // out of iterations or broken down
    }
    result.converged = result.residual <= settings.tolerance;
    result.solve_seconds = seconds_since(start);
    return result;
}

}  // namespace contactd::fem

// Conjugate gradients preconditioned by BoomerAMG, stopped by the true residual.
#pragma once

#include <functional>

#include <mfem.hpp>

namespace contactd::fem {

struct PcgSettings {
    double tolerance = 1e-8;  ///< on ||b - A x|| / ||b||
    int max_iterations = 1000;
    double strength_threshold = 0.5;  ///< of BoomerAMG
};

struct PcgResult {
    int iterations = 0;
    double residual = 0;  ///< true relative residual ||b - A x|| / ||b||, computed from x
    bool converged = false;
    double setup_seconds = 0;
    double solve_seconds = 0;
};

/// Called after the setup with iteration 0 and then after each iteration, on all processes.
using PcgMonitor = std::function<void(int iteration, double residual)>;

/// Collective. Solves A x = b for a system of three displacements per node (byVDIM), from x = 0.
PcgResult solve_amg_pcg(const mfem::HypreParMatrix& A, const mfem::Vector& b, mfem::Vector& x,
                        const PcgSettings& settings, const PcgMonitor& monitor);

}  // namespace contactd::fem

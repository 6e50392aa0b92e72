// The roots of a few functions that cost a solve each time.
#pragma once

#include <functional>
#include <vector>

namespace contactd {

struct EquilibriumTask {
    using Values = std::vector<double>;

    std::function<Values(const Values& x)> residuals;  ///< as many as unknowns; not numbers where there are none
    Values start;
    Values low, high;   ///< nowhere beyond
    Values first_step;  ///< the longest one of each unknown at first, > 0
    /// Derivatives of the residuals by the unknowns, row by row, as they are expected.
    Values slopes;
    double tolerance = 0;  ///< of all |residuals|
    int max_evaluations = 40;
};

/// Where the functions were evaluated last.
struct EquilibriumFound {
    EquilibriumTask::Values at, slopes;  ///< the slopes as they were learnt
    double residual = 0;                 ///< the largest
    int evaluations = 0;
    bool converged = false;
};

/// Broyden's method within bounds: steps by slopes that each evaluation corrects. One that does not come nearer is
/// halved; a function that jumps, or has no root, does not converge.
EquilibriumFound find_equilibrium(const EquilibriumTask& task);

}  // namespace contactd

// The roots of a few functions whose evaluation costs a solve.
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
    /// Expected derivatives of the residuals by the unknowns, row by row.
    Values slopes;
    double tolerance = 0;  ///< of all |residuals|
    int max_evaluations = 40;
};

/// The last point of evaluation.
struct EquilibriumFound {
    EquilibriumTask::Values at, slopes;  ///< the slopes as they were learnt
    double residual = 0;                 ///< the largest
    int evaluations = 0;
    bool converged = false;
};

/// Broyden's method within bounds: each evaluation corrects the slopes of the next step. A step that does not reduce
/// the residual is halved. A function with a jump, or without a root, does not converge.
EquilibriumFound find_equilibrium(const EquilibriumTask& task);

}  // namespace contactd

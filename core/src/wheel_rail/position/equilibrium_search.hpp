// Finds the roots of a few functions whose evaluation costs a solve.
#pragma once

#include <functional>
#include <vector>

namespace contactd {

struct EquilibriumTask {
    using Values = std::vector<double>;

    std::function<Values(const Values& x)> residuals;  ///< has as many values as unknowns; NaN where they are undefined
    Values start;
    Values low, high;   ///< bounds of the search
    Values first_step;  ///< longest first step of each unknown, > 0
    /// Holds the expected derivatives of the residuals with respect to the unknowns, row by row.
    Values slopes;
    double tolerance = 0;  ///< of all |residuals|
    int max_evaluations = 40;
};

/// Describes the last point of evaluation.
struct EquilibriumFound {
    EquilibriumTask::Values at, slopes;  ///< slopes as corrected by the search
    double residual = 0;                 ///< the largest
    int evaluations = 0;
    bool converged = false;
};

/// Searches by Broyden's method within bounds: each evaluation corrects the slopes of the next step. A step that does
/// not reduce the residual is halved. A function with a jump, or without a root, does not converge.
EquilibriumFound find_equilibrium(const EquilibriumTask& task);

}  // namespace contactd

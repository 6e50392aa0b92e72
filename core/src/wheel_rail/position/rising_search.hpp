// Finds the root of an increasing, expensive function.
#pragma once

#include <functional>

namespace contactd {

struct RisingTask {
    std::function<double(double)> function;
    double start = 0;
    double step = 1;           ///< first one, > 0
    double low = 0, high = 0;  ///< bounds of the search
    double tolerance = 0;      ///< of |function|
    int max_evaluations = 40;
};

/// Describes the last point of evaluation.
struct RisingFound {
    double at = 0, value = 0;
    int evaluations = 0;
    bool converged = false;
};

/// Searches by the secant method between shrinking bounds. A jump across zero does not converge.
RisingFound find_rising(const RisingTask& task);

}  // namespace contactd

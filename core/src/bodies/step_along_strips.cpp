#include "step_along_strips.hpp"

#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {

StepAlongStrips step_along_strips(const ContactProblem& problem) {
    constexpr double rounding = 1e-9;
    const auto [x, y] = step_of(problem);
    if (std::abs(y) > rounding * std::abs(x))
        throw InvalidArgument(
            "friction.rolling.chi",
            "is " + number_text(std::get<Rolling>(problem.motion).chi) +
                "; bodies with a cross-section are uniform along x and must roll along it: use 0 or pi");
    const double steps = x / problem.grid.dx, nearest = std::round(steps);
    if (std::abs(steps) > problem.grid.nx)
        throw InvalidArgument(
            "friction.rolling.dq",
            "is " + number_text(std::abs(x)) +
                " mm; for bodies with a cross-section it must not exceed the length of the grid along x, " +
                number_text(problem.grid.nx * problem.grid.dx) + " mm");
    if (std::abs(steps - nearest) <= rounding) return {static_cast<int>(nearest), 0};
    return {static_cast<int>(std::floor(steps)), steps - std::floor(steps)};
}

}  // namespace contactd

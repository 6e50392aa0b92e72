// Computes steps of rolling of bodies whose coefficients differ from strip to strip.
#pragma once

#include <cstdlib>

#include "contactd/contact.hpp"

namespace contactd {

/// Describes a step of rolling along x, in elements. It is zero if the bodies do not roll.
struct StepAlongStrips {
    int whole = 0;        ///< the step, or its whole part
    double fraction = 0;  ///< 0 <= fraction < 1

    int reach() const { return std::abs(fraction == 0 ? whole : whole + 1); }
};

/// Returns the step of a problem. Throws InvalidArgument ("friction.rolling.chi" and ".dq") for a step that is not
/// along x, or longer than the grid.
StepAlongStrips step_along_strips(const ContactProblem& problem);

}  // namespace contactd

// Steps of rolling of bodies whose coefficients differ from strip to strip.
#pragma once

#include <cstdlib>

#include "contactd/contact.hpp"

namespace contactd {

/// A step of rolling along x, in elements; zero where the bodies do not roll.
struct StepAlongStrips {
    int whole = 0;        ///< of a step by whole elements, else the part below
    double fraction = 0;  ///< 0 <= fraction < 1

    int reach() const { return std::abs(fraction == 0 ? whole : whole + 1); }
};

/// Throws InvalidArgument: "friction.rolling.chi" and ".dq" for a step that is not along x, or longer than the grid.
StepAlongStrips step_along_strips(const ContactProblem& problem);

}  // namespace contactd

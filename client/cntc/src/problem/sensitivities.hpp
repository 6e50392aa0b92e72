// Derivatives of the forces.
#pragma once

#include "problem/contact_case.hpp"

namespace contactd::cntc {

/// At the approach and motion of the solution, whichever of them was prescribed, the division of the elements held;
/// with a slip law central differences of solves with tight tolerances. Without `tangential`, or without friction, only
/// that of Fn by the approach, and NaN else. Throws Refused where a solve misses its tolerance.
Sensitivities sensitivities(const ContactProblem& problem, const ContactSolution& solution, ContactSolver& solver,
                            bool tangential);

}  // namespace contactd::cntc

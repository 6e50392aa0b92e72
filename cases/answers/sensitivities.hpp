// Derivatives of the forces.
#pragma once

#include "answers/contact_solver.hpp"
#include "answers/solved.hpp"

namespace contactd::cases {

/// Sensitivities at the approach and motion of the solution, prescribed or not, with a frozen element division;
/// with a slip law central differences of solves with tight tolerances. Without `tangential`, or without friction, only
/// that of Fn by the approach, and NaN else. Throws NotCovered where a solve misses its tolerance.
Sensitivities sensitivities(const ContactProblem& problem, const ContactSolution& solution, ContactSolver& solver,
                            bool tangential);

}  // namespace contactd::cases

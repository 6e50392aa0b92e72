// Computes derivatives of the forces.
#pragma once

#include "answers/contact_solver.hpp"
#include "answers/solved.hpp"

namespace contactd::cases {

/// Returns sensitivities at the approach and motion of the solution, prescribed or found, for a frozen element
/// division. With a slip law they are central differences of solves with tight tolerances. Without `tangential`, or
/// without friction, only that of Fn by the approach is computed, and the others are NaN. Throws NotCovered if a solve
/// does not reach its tolerance.
Sensitivities sensitivities(const ContactProblem& problem, const ContactSolution& solution, ContactSolver& solver,
                            bool tangential);

}  // namespace contactd::cases

// Derivatives of the forces, by differences of solves.
#pragma once

#include "problem/contact_case.hpp"

namespace contactd::cntc {

/// At the approach and motion of the solution, whichever of them was prescribed. Central differences of solves with
/// tight tolerances; without `tangential`, or without friction, only that of Fn by the approach, and NaN else. Throws
/// Refused where a solve misses its tolerance.
Sensitivities sensitivities(const ContactProblem& problem, const ContactSolution& solution, ContactSolver& solver,
                            bool tangential);

}  // namespace contactd::cntc

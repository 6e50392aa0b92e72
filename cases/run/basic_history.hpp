// Computes steps of basic contact: each one may start from the end of the case before.
#pragma once

#include "answers/solved.hpp"
#include "given/given.hpp"

namespace contactd::cases {

/// Returns a problem that was made by problem_of, with its solution in CONTACT's quantities. `last` is the case before;
/// null: there is none.
Solved solved_step(const Given& given, ContactProblem problem, ContactSolution solution, const Solved* last);

/// Returns the evidence that decides on convergence: without outer iterations if the case allows only one.
ContactEvidence required_evidence(const Solved& solved);

}  // namespace contactd::cases

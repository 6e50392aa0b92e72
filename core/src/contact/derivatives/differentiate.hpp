// Derivatives of a solved contact, by implicit differentiation of its equations.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Gives a converged solution as the solvers leave it, its slip in mm, `derivatives` and their evidence. Where the
/// equations do not reach their tolerance, and without contact, it gets none, and a warning. Throws Cancelled.
void differentiate(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer,
                   ContactSolution& solution);

}  // namespace contactd

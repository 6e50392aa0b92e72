// Solves contact problems.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Solves normal contact and, with friction, tangential contact by the problem's model. The full model requires the
/// operators. The evidence of the solution reports missed tolerances. Throws InvalidArgument if the problem is invalid
/// or the operators belong to another grid, and Cancelled.
ContactSolution solve_contact(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer);

}  // namespace contactd

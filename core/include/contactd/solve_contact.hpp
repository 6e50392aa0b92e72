// A contact problem and its solution.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Normal contact and, where the problem has friction, tangential contact, by the problem's model; the full one needs
/// the operators. A solution that missed a tolerance says so in its evidence. Throws InvalidArgument when the problem
/// is invalid or the operators are of another grid, and Cancelled.
ContactSolution solve_contact(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer);

}  // namespace contactd

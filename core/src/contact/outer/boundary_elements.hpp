// Solves contact by boundary elements: normal contact, tangential contact, and the loop between them.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Sets everything in a solution except the sums over its arrays. `problem` is valid, and its operators fit.
ContactSolution solve_boundary_elements(const ContactProblem& problem, const ContactInfluence& influence,
                                        Observer& observer);

}  // namespace contactd

// Temperatures of a contact that was solved.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Takes temperatures, where the problem asks for them, into the solution, whose slip is relative; and their warnings;
/// and the speed that they depend on.
void find_temperature(const ContactProblem& problem, ContactSolution& solution, Observer& observer);

}  // namespace contactd

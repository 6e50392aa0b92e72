// Computes temperatures of a solved contact.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// If the problem requests temperatures, adds them, their warnings and the speed that they depend on to the solution,
/// whose slip is relative.
void find_temperature(const ContactProblem& problem, ContactSolution& solution, Observer& observer);

}  // namespace contactd

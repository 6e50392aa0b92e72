// Tells whether the answer to a contact with friction is the only one.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// The gain of the loop from slip to friction to tractions to slip, at the solution: below 1 there is one answer. Of a
/// layer that softens and of friction that falls without memory; 0 of all else, and where the bodies' moduli are not
/// known. `influence` is that of the bodies with the layer (docs/friction.md). Throws Cancelled between its products,
/// at most twenty.
double loop_gain(const ContactProblem& problem, const InfluenceOperator& influence, const ContactSolution& solution,
                 const Observer& observer);

/// Sentences about a gain above 1, about outer iterations that have not settled, and about steps in which particles
/// slip farther than they remember.
std::vector<std::string> friction_warnings(const ContactProblem& problem, const InfluenceOperator& influence,
                                           const ContactSolution& solution, const Observer& observer);

}  // namespace contactd

// Uniqueness of the solution of a contact with friction.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Returns the gain of the loop from slip to friction to tractions to slip, at the solution. Below 1 the solution is
/// unique. The gain is that of a softening layer, or of falling friction without memory. It is 0 otherwise, and if the
/// moduli of the bodies are unknown. `influence` is the operator of the bodies with the layer (docs/friction.md).
/// Throws Cancelled between its products, of which there are at most twenty.
double loop_gain(const ContactProblem& problem, const InfluenceOperator& influence, const ContactSolution& solution,
                 const Observer& observer);

/// Returns warnings about a gain above 1, about outer iterations that did not converge, and about steps in which
/// particles slip farther than the distance of their memory.
std::vector<std::string> friction_warnings(const ContactProblem& problem, const InfluenceOperator& influence,
                                           const ContactSolution& solution, const Observer& observer);

}  // namespace contactd

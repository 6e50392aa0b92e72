// Estimates errors and creates warnings for the number of elements in a contact and for the rolling step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Estimates the discretisation errors of a boundary-element solution with its pressures and sums. Returns nothing
/// without contact. `coupled` means that pressures also depend on tangential tractions, so Hertz's theory does not
/// hold. Throws InvalidArgument if the elements are too wide to resolve a layer.
std::optional<Discretisation> discretisation(const ContactProblem& problem, const ContactSolution& solution,
                                             bool coupled);

/// Returns warnings about elements or a step that are too large for the contact.
std::vector<std::string> discretisation_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

// How finely the elements divide a contact, what that costs, and when to say so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Estimates the errors of a solution by boundary elements, which has its pressures and sums; nothing without contact.
/// `coupled`: pressures depend on tangential tractions too, so that Hertz's theory does not hold. Throws
/// InvalidArgument where the elements are so wide beside a layer that the solution says nothing of it.
std::optional<Discretisation> discretisation(const ContactProblem& problem, const ContactSolution& solution,
                                             bool coupled);

/// Sentences about elements or a step that are too large for the contact; mostly none.
std::vector<std::string> discretisation_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

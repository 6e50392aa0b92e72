// Checks the strips on which a contact of longitudinally uniform bodies lies.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument: "columns" where they are missing and a longitudinally uniform body is not flat;
/// "columns.frames[i]" where they are not those of the lower body's section, but for where it lies, or the upper one's
/// section does not lie along them.
void check_strips_of_uniform(const ContactProblem& problem);

}  // namespace contactd

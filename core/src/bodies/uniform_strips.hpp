// Checks the strips of a contact of longitudinally uniform bodies.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument ("columns") if strips are missing and a longitudinally uniform body is not flat. Throws
/// InvalidArgument ("columns.frames[i]") if they differ, apart from their position, from those of the lower body's
/// section, or if the upper one's section does not lie along them.
void check_strips_of_uniform(const ContactProblem& problem);

}  // namespace contactd

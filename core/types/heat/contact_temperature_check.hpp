// Checks whether temperatures of a contact are known.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument naming the field as on the wire; nothing where no temperatures are wanted. `problem` is
/// checked otherwise; where it is not `complete` later steps may bring friction.
void check_temperature(const ContactProblem& problem, bool complete);

}  // namespace contactd

// Checks whether the fatigue of a contact is known.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument naming the field as on the wire; nothing where no fatigue is wanted. `problem` is checked
/// otherwise; where it is not `complete` later steps may bring friction.
void check_fatigue(const ContactProblem& problem, bool complete);

/// Throws InvalidArgument ("model") where the model does not tell the tractions of each element.
void check_fatigue_model(Model model);

}  // namespace contactd

// Checks whether the fatigue of a contact can be computed.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument, which names the field as on the wire, if it cannot; never if no fatigue is requested. Other
/// properties of `problem` are not checked. If it is not `complete`, later steps may add friction.
void check_fatigue(const ContactProblem& problem, bool complete);

/// Throws InvalidArgument ("model") if the model does not compute the tractions of each element.
void check_fatigue_model(Model model);

}  // namespace contactd

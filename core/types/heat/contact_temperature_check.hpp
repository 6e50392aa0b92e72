// Checks whether temperatures of a contact can be computed.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument, which names the field as on the wire, if they cannot; never if no temperatures are
/// requested. Other properties of `problem` are not checked. If it is not `complete`, later steps may add friction.
void check_temperature(const ContactProblem& problem, bool complete);

}  // namespace contactd

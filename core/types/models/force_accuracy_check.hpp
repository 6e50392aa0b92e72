// Checks whether the tangential forces of a contact can be extrapolated.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument, which names the field as on the wire, if they cannot; never if no accuracy is requested.
/// Other properties of `problem` are not checked. If it is not `complete`, later steps may add friction and the gap.
void check_force_accuracy(const ContactProblem& problem, bool complete);

}  // namespace contactd

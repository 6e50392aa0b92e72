// Checks whether a contact can be solved on its curved columns.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument, which names the field as on the wire, if it cannot; never on a plane. Other properties of
/// `problem` are not checked.
void check_columns(const ContactProblem& problem);

}  // namespace contactd

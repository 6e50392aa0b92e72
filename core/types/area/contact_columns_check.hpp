// Whether a contact can be solved on the curved columns that it states.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument naming the field as on the wire; nothing on a plane. `problem` is checked otherwise.
void check_columns(const ContactProblem& problem);

}  // namespace contactd

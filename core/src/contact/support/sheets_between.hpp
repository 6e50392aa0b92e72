// Adds the sheets between two bodies to their operators.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"

namespace contactd {

/// Returns the operators with the sheet of the problem and the layer of a third body, which shears like a sheet.
ContactInfluence with_sheets(const ContactProblem& problem, ContactInfluence bodies);

}  // namespace contactd

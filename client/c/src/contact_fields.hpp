// The inputs and the results of a contact as their paths name them.
#pragma once

#include "contactd/fields.hpp"
#include "contactd/ic_reply.hpp"

namespace contactd::c {

/// The fields of ContactProblem without its bodies, as those of contact.solve. "friction.mu" is an array of one number
/// or of one for each element; "gap", "friction" and lists are made by naming a field of them.
const FieldType& type_of_problem();
/// The fields of ContactInputs beside these: "bodies.upper", "bodies.lower", "ics", "lease_seconds",
/// "accept_unconverged". An elastic body has G and nu, a rigid one rigid; naming a field of "ics" replaces a table.
const FieldType& type_of_bodies_and_session();

/// The fields of ContactSolution, of which "motion" has the fields of a shift or of rolling.
const FieldType& type_of_solution();

}  // namespace contactd::c

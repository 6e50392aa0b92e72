// Describes fields of the inputs and results of contacts and wheels by their paths.
#pragma once

#include "contactd/fields.hpp"
#include "contactd/ic_reply.hpp"

namespace contactd::c {

/// Returns the fields of ContactProblem without its bodies, as in contact.solve. "friction.mu" is an array of one
/// number or of one per element; setting a field creates "gap", "friction" and lists.
const FieldType& type_of_problem();
/// Returns other fields of ContactInputs: "bodies.upper", "bodies.lower", "ics", "lease_seconds",
/// "accept_unconverged". An elastic body has G and nu, a rigid one rigid; setting a field of "ics" replaces a table.
const FieldType& type_of_bodies_and_session();
/// Returns the fields of Section: "rail_60e1.inclination", "outline.outside.parts[0].line.to.y", "size". Setting a
/// field of a shape, or of a part's curve, selects it for the section or the part.
const FieldType& type_of_section();
/// Returns the fields of WheelInput, "setup" and "state". Materials, whose form on the wire differs, are objects
/// here: "setup.bodies.lower.G" makes the wheel elastic.
const FieldType& type_of_wheel_input();

/// Returns the fields of ContactSolution; "motion" has the fields of a shift or of rolling.
const FieldType& type_of_solution();

}  // namespace contactd::c

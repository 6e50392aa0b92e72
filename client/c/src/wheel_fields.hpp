// The inputs of a wheel as their paths name them.
#pragma once

#include "contactd/fields.hpp"

namespace contactd::c {

/// The fields of WheelInput, "setup" and "state". Materials, which have a form of their own on the wire, are objects
/// here: "setup.bodies.lower.G" makes the wheel elastic.
const FieldType& type_of_wheel_input();

}  // namespace contactd::c

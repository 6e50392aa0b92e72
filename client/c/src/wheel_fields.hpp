// Fields of the inputs of a wheel by their paths.
#pragma once

#include "contactd/fields.hpp"

namespace contactd::c {

/// The fields of WheelInput, "setup" and "state". Materials, whose form on the wire differs, are objects here:
/// "setup.bodies.lower.G" makes the wheel elastic.
const FieldType& type_of_wheel_input();

}  // namespace contactd::c

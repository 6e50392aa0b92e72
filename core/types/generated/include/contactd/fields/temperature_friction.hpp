// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/friction_with_memory.hpp"
#include "contactd/temperature_friction.hpp"

namespace contactd {

template <>
const FieldType& type_of<TemperatureFriction>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/friction_with_memory.hpp"

namespace contactd {

template <>
const FieldType& type_of<FrictionMemory>();

}  // namespace contactd

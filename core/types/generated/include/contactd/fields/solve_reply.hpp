// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/solve_reply.hpp"

namespace contactd {

template <>
const FieldType& type_of<OperatorUse>();

}  // namespace contactd

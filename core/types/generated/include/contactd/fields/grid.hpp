// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/grid.hpp"

namespace contactd {

template <>
const FieldType& type_of<Grid>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/contact_columns.hpp"
#include "contactd/fields.hpp"

namespace contactd {

template <>
const FieldType& type_of<Resultant>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/contact_columns.hpp"
#include "contactd/fields.hpp"
#include "contactd/fields/section.hpp"

namespace contactd {

template <>
const FieldType& type_of<ContactColumns>();
template <>
const FieldType& type_of<Resultant>();

}  // namespace contactd

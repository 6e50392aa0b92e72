// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/section.hpp"

namespace contactd {

template <>
const FieldType& type_of<SectionPoint>();

}  // namespace contactd

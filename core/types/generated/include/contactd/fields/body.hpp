// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/body.hpp"
#include "contactd/fields.hpp"

namespace contactd {

template <>
const FieldType& type_of<Viscoelasticity>();

}  // namespace contactd

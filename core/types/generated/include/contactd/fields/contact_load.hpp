// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/contact_load.hpp"
#include "contactd/fields.hpp"

namespace contactd {

template <>
const FieldType& type_of<SurfaceState>();

}  // namespace contactd

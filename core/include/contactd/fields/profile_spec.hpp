// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

template <>
const FieldType& type_of<ProfilePoint>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/gap.hpp"

namespace contactd {

template <>
const FieldType& type_of<Gap>();
template <>
const FieldType& type_of<Paraboloid>();
template <>
const FieldType& type_of<SemiAxes>();
template <>
const FieldType& type_of<HalfEllipses>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/derivatives.hpp"
#include "contactd/fields.hpp"

namespace contactd {

template <>
const FieldType& type_of<Derivatives>();
template <>
const FieldType& type_of<DerivativesOfAnswer>();
template <>
const FieldType& type_of<DerivativesByShift>();

}  // namespace contactd

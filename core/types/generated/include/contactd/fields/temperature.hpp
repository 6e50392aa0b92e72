// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/temperature.hpp"

namespace contactd {

template <>
const FieldType& type_of<SurfaceTemperatures>();
template <>
const FieldType& type_of<ThermalBody>();
template <>
const FieldType& type_of<ThermalBodies>();
template <>
const FieldType& type_of<ContactTemperature>();

}  // namespace contactd

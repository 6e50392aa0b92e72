// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

template <>
const FieldType& type_of<WheelRailState>();
template <>
const FieldType& type_of<WheelsetPosition>();
template <>
const FieldType& type_of<WheelsetVelocity>();
template <>
const FieldType& type_of<RailDeviation>();
template <>
const FieldType& type_of<WheelsetState>();

}  // namespace contactd

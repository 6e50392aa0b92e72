// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<WheelRailMotion> =
    std::to_array<std::string_view>({"steady_rolling", "transient_rolling", "shift"});
static_assert(static_cast<int>(WheelRailMotion::steady_rolling) == 0);
static_assert(static_cast<int>(WheelRailMotion::transient_rolling) == 1);
static_assert(static_cast<int>(WheelRailMotion::shift) == 2);

template <>
const FieldType& type_of<WheelRailState>();
template <>
const FieldType& type_of<WheelsetPosition>();
template <>
const FieldType& type_of<WheelsetVelocity>();
template <>
const FieldType& type_of<WheelDeviation>();
template <>
const FieldType& type_of<RailDeviation>();
template <>
const FieldType& type_of<WheelsetState>();

}  // namespace contactd

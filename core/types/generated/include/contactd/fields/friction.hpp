// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/friction_with_memory.hpp"
#include "contactd/friction.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<SlipLaw> = std::to_array<std::string_view>({"linear", "exponential", "rational"});
static_assert(static_cast<int>(SlipLaw::linear) == 0);
static_assert(static_cast<int>(SlipLaw::exponential) == 1);
static_assert(static_cast<int>(SlipLaw::rational) == 2);

template <>
inline constexpr auto enum_words<SlipStart> = std::to_array<std::string_view>({"adhesion", "full_slip"});
static_assert(static_cast<int>(SlipStart::adhesion) == 0);
static_assert(static_cast<int>(SlipStart::full_slip) == 1);

template <>
inline constexpr auto enum_words<RollingKind> = std::to_array<std::string_view>({"steady", "transient"});
static_assert(static_cast<int>(RollingKind::steady) == 0);
static_assert(static_cast<int>(RollingKind::transient) == 1);

template <>
inline constexpr auto enum_words<MotionKind> = std::to_array<std::string_view>({"shift", "rolling"});
static_assert(static_cast<int>(MotionKind::shift) == 0);
static_assert(static_cast<int>(MotionKind::rolling) == 1);

template <>
const FieldType& type_of<KineticFriction>();
template <>
const FieldType& type_of<SecondTerm>();
template <>
const FieldType& type_of<InterfacialLayer>();
template <>
const FieldType& type_of<RigidShift>();
template <>
const FieldType& type_of<RigidSlip>();
template <>
const FieldType& type_of<Force>();
template <>
const FieldType& type_of<Rolling>();

}  // namespace contactd

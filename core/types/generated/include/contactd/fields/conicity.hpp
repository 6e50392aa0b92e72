// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/conicity.hpp"
#include "contactd/fields.hpp"
#include "contactd/fields/profile_evidence.hpp"
#include "contactd/fields/profile_spec.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<WheelsetRoll> = std::to_array<std::string_view>({"demanded", "neglected"});
static_assert(static_cast<int>(WheelsetRoll::demanded) == 0);
static_assert(static_cast<int>(WheelsetRoll::neglected) == 1);

template <>
const FieldType& type_of<ContactsRequest>();
template <>
const FieldType& type_of<ConicityRequest>();
template <>
const FieldType& type_of<WheelsetContacts>();
template <>
const FieldType& type_of<RigidContact>();
template <>
const FieldType& type_of<ProfilesOfSides>();
template <>
const FieldType& type_of<PlacedProfiles>();

}  // namespace contactd

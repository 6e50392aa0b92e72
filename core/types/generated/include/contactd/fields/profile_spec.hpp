// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<StandardName> =
    std::to_array<std::string_view>({"S1002", "UIC60", "49E5", "54E1", "54E3", "60E1", "60E2"});
static_assert(static_cast<int>(StandardName::S1002) == 0);
static_assert(static_cast<int>(StandardName::UIC60) == 1);
static_assert(static_cast<int>(StandardName::n49E5) == 2);
static_assert(static_cast<int>(StandardName::n54E1) == 3);
static_assert(static_cast<int>(StandardName::n54E3) == 4);
static_assert(static_cast<int>(StandardName::n60E1) == 5);
static_assert(static_cast<int>(StandardName::n60E2) == 6);

template <>
const FieldType& type_of<ProfileSpec>();
template <>
const FieldType& type_of<Rail60E1>();
template <>
const FieldType& type_of<ArcProfile>();
/// Fields that are members of ArcProfile and of ConeProfile.
template <class Owner>
struct ProfileEnds;
template <>
const FieldType& type_of<ProfileEnds<ArcProfile>>();
template <>
const FieldType& type_of<ProfileEnds<ConeProfile>>();
template <>
const FieldType& type_of<ConeProfile>();
template <>
const FieldType& type_of<StandardProfile>();
template <>
const FieldType& type_of<ProfileFile>();
template <>
const FieldType& type_of<KinkRule>();
template <>
const FieldType& type_of<ProfilePoint>();

}  // namespace contactd

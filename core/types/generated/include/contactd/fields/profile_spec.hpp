// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

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
const FieldType& type_of<ProfileFile>();
template <>
const FieldType& type_of<KinkRule>();
template <>
const FieldType& type_of<ProfilePoint>();

}  // namespace contactd

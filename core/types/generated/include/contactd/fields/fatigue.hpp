// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fatigue.hpp"
#include "contactd/fields.hpp"
#include "contactd/fields/wear.hpp"

namespace contactd {

template <>
const FieldType& type_of<FatigueStrength>();
template <>
const FieldType& type_of<DamageFunction>();
template <>
const FieldType& type_of<Passage>();
template <>
const FieldType& type_of<ResidualStress>();
template <>
const FieldType& type_of<FatigueRequest>();
template <>
const FieldType& type_of<StressPlace>();
template <>
const FieldType& type_of<ContactFatigue>();
template <>
const FieldType& type_of<FunctionDamage>();
template <>
const FieldType& type_of<FatigueRow>();

}  // namespace contactd

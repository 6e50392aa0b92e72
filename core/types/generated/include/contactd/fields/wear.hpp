// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/wear.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<WornBody> = std::to_array<std::string_view>({"upper", "lower"});
static_assert(static_cast<int>(WornBody::upper) == 0);
static_assert(static_cast<int>(WornBody::lower) == 1);

template <>
inline constexpr auto enum_words<WearEnergy> = std::to_array<std::string_view>({"scaled", "plain"});
static_assert(static_cast<int>(WearEnergy::scaled) == 0);
static_assert(static_cast<int>(WearEnergy::plain) == 1);

template <>
const FieldType& type_of<WearPiece>();
template <>
const FieldType& type_of<WearRange>();
template <>
const FieldType& type_of<WearLaw>();
template <>
const FieldType& type_of<ArchardWear>();
template <>
const FieldType& type_of<SevereWear>();
template <>
const FieldType& type_of<SeizureWear>();
template <>
const FieldType& type_of<EnergyWear>();
template <>
const FieldType& type_of<UsfdWear>();
template <>
const FieldType& type_of<BrWear>();
template <>
const FieldType& type_of<ZoboryWear>();
template <>
const FieldType& type_of<WearZone>();
template <>
const FieldType& type_of<WearRequest>();
template <>
const FieldType& type_of<ContactWear>();
template <>
const FieldType& type_of<WearRow>();
template <>
const FieldType& type_of<LawWear>();

}  // namespace contactd

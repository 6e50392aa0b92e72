// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/contact.hpp"
#include "contactd/fields.hpp"
#include "contactd/fields/contact_columns.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<ErrorSource> = std::to_array<std::string_view>({"hertz", "estimate"});
static_assert(static_cast<int>(ErrorSource::hertz) == 0);
static_assert(static_cast<int>(ErrorSource::estimate) == 1);

template <>
const FieldType& type_of<ContactSolution>();
template <>
const FieldType& type_of<Forces>();
template <>
const FieldType& type_of<Areas>();
template <>
const FieldType& type_of<Counts>();
template <>
const FieldType& type_of<ContactEvidence>();
template <>
const FieldType& type_of<Discretisation>();
template <>
const FieldType& type_of<SolverEvidence>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/axis.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

template <>
const FieldType& type_of<IcEvidence>();
template <>
const FieldType& type_of<BuildSeconds>();
template <>
const FieldType& type_of<LoadCaseEvidence>();
template <>
const FieldType& type_of<IcErrors>();
template <>
const FieldType& type_of<ComponentError>();
template <>
const FieldType& type_of<SectionEvidence>();

}  // namespace contactd

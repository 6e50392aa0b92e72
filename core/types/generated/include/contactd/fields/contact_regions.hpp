// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/contact_regions.hpp"
#include "contactd/fields.hpp"

namespace contactd {

template <>
const FieldType& type_of<Extent>();
template <>
const FieldType& type_of<RegionLimits>();
template <>
const FieldType& type_of<ContactRegions>();

}  // namespace contactd

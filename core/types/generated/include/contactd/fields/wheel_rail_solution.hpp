// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/fields/contact_regions.hpp"
#include "contactd/fields/grid.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

template <>
const FieldType& type_of<Wrench>();
template <>
const FieldType& type_of<WheelRailForces>();
template <>
const FieldType& type_of<WheelRailDerivatives>();
template <>
const FieldType& type_of<WheelRailDerivatives::ByPosition>();
template <>
const FieldType& type_of<WheelRailDerivatives::ByVelocity>();
template <>
const FieldType& type_of<ProfileFrame>();
template <>
const FieldType& type_of<ContactReference>();
template <>
const FieldType& type_of<ContactPlace>();
template <>
const FieldType& type_of<RailPlace>();
template <>
const FieldType& type_of<OverlapRegion>();
template <>
const FieldType& type_of<Creepages>();
template <>
const FieldType& type_of<ContactRadii>();
template <>
const FieldType& type_of<ContactRow>();
template <>
const FieldType& type_of<WheelRailGeometry>();
template <>
const FieldType& type_of<WheelRailSolution>();
template <>
const FieldType& type_of<WheelRailPatch>();
template <>
const FieldType& type_of<RailDeflection>();
template <>
const FieldType& type_of<WheelsetSolution>();

}  // namespace contactd

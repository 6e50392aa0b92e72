// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/fields/friction.hpp"
#include "contactd/fields/gap.hpp"
#include "contactd/fields/grid.hpp"
#include "contactd/fields/ic_reply.hpp"
#include "contactd/fields/temperature_friction.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/session.hpp"

namespace contactd {

/// Fields that are members of ContactProblem and of StepInput.
template <class Owner>
struct FrictionFields;
template <>
const FieldType& type_of<FrictionFields<ContactProblem>>();
template <>
const FieldType& type_of<FrictionFields<StepInput>>();
template <>
const FieldType& type_of<SessionInfo>();
template <>
const FieldType& type_of<SessionReply>();
template <>
const FieldType& type_of<StepInput>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/subsurface_stress.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<ContactBody> = std::to_array<std::string_view>({"upper", "lower"});
static_assert(static_cast<int>(ContactBody::upper) == 0);
static_assert(static_cast<int>(ContactBody::lower) == 1);

template <>
const FieldType& type_of<LargestStress>();

}  // namespace contactd

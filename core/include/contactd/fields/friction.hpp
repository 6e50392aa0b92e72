// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/friction.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<SlipLaw> = std::to_array<std::string_view>({"linear", "exponential"});
static_assert(static_cast<int>(SlipLaw::linear) == 0);
static_assert(static_cast<int>(SlipLaw::exponential) == 1);

template <>
const FieldType& type_of<KineticFriction>();

}  // namespace contactd

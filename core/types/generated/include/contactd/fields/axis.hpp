// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/axis.hpp"
#include "contactd/fields.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<Axis> = std::to_array<std::string_view>({"x", "y", "z"});
static_assert(static_cast<int>(Axis::x) == 0);
static_assert(static_cast<int>(Axis::y) == 1);
static_assert(static_cast<int>(Axis::z) == 2);

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/ic_table.hpp"
#include "contactd/ic_reply.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<FileFormat> = std::to_array<std::string_view>({"hdf5", "contents", "contact"});
static_assert(static_cast<int>(FileFormat::hdf5) == 0);
static_assert(static_cast<int>(FileFormat::contents) == 1);
static_assert(static_cast<int>(FileFormat::contact) == 2);

template <>
const FieldType& type_of<IcUses>();
template <>
const FieldType& type_of<IcUse>();

}  // namespace contactd

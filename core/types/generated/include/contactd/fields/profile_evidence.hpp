// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/profile_spec.hpp"
#include "contactd/profile_evidence.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<ProfileFormat> = std::to_array<std::string_view>({"simpack", "miniprof", "columns"});
static_assert(static_cast<int>(ProfileFormat::simpack) == 0);
static_assert(static_cast<int>(ProfileFormat::miniprof) == 1);
static_assert(static_cast<int>(ProfileFormat::columns) == 2);

template <>
inline constexpr auto enum_words<OrientedBy> = std::to_array<std::string_view>({"file", "shape", "request"});
static_assert(static_cast<int>(OrientedBy::file) == 0);
static_assert(static_cast<int>(OrientedBy::shape) == 1);
static_assert(static_cast<int>(OrientedBy::request) == 2);

template <>
const FieldType& type_of<ProfileEvidence>();
template <>
const FieldType& type_of<WheelLandmarks>();
template <>
const FieldType& type_of<ProfileReading>();

}  // namespace contactd

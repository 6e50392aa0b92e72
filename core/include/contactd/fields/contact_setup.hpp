// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/contact_setup.hpp"
#include "contactd/fields.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<Model> = std::to_array<std::string_view>({"full", "hertz", "fastsim"});
static_assert(static_cast<int>(Model::full) == 0);
static_assert(static_cast<int>(Model::hertz) == 1);
static_assert(static_cast<int>(Model::fastsim) == 2);

template <>
inline constexpr auto enum_words<TangentialSolver> = std::to_array<std::string_view>({"newton", "tangcg"});
static_assert(static_cast<int>(TangentialSolver::newton) == 0);
static_assert(static_cast<int>(TangentialSolver::tangcg) == 1);

template <>
const FieldType& type_of<ContactSettings>();
template <>
const FieldType& type_of<SolverSettings>();
/// Fields that are members of ContactSettings.
template <class Owner>
struct TangentialSettings;
template <>
const FieldType& type_of<TangentialSettings<ContactSettings>>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/contact_setup.hpp"
#include "contactd/fields.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<Model> =
    std::to_array<std::string_view>({"full", "hertz", "fastsim", "fastrip", "polach"});
static_assert(static_cast<int>(Model::full) == 0);
static_assert(static_cast<int>(Model::hertz) == 1);
static_assert(static_cast<int>(Model::fastsim) == 2);
static_assert(static_cast<int>(Model::fastrip) == 3);
static_assert(static_cast<int>(Model::polach) == 4);

template <>
inline constexpr auto enum_words<TangentialSolver> = std::to_array<std::string_view>({"newton", "tangcg"});
static_assert(static_cast<int>(TangentialSolver::newton) == 0);
static_assert(static_cast<int>(TangentialSolver::tangcg) == 1);

template <>
inline constexpr auto enum_words<NormalModel> =
    std::to_array<std::string_view>({"of_model", "kp", "kpec", "analyn", "elliptic", "parabolic"});
static_assert(static_cast<int>(NormalModel::of_model) == 0);
static_assert(static_cast<int>(NormalModel::kp) == 1);
static_assert(static_cast<int>(NormalModel::kpec) == 2);
static_assert(static_cast<int>(NormalModel::analyn) == 3);
static_assert(static_cast<int>(NormalModel::elliptic) == 4);
static_assert(static_cast<int>(NormalModel::parabolic) == 5);

template <>
inline constexpr auto enum_words<TractionBound> = std::to_array<std::string_view>({"parabolic", "elliptic"});
static_assert(static_cast<int>(TractionBound::parabolic) == 0);
static_assert(static_cast<int>(TractionBound::elliptic) == 1);

template <>
inline constexpr auto enum_words<CreepageCoefficients> = std::to_array<std::string_view>({"computed", "printed"});
static_assert(static_cast<int>(CreepageCoefficients::computed) == 0);
static_assert(static_cast<int>(CreepageCoefficients::printed) == 1);

template <>
const FieldType& type_of<ContactSettings>();
template <>
const FieldType& type_of<SolverSettings>();
/// Fields that are members of ContactSettings.
template <class Owner>
struct TangentialSettings;
template <>
const FieldType& type_of<TangentialSettings<ContactSettings>>();
template <>
const FieldType& type_of<SimplifiedSettings>();
template <>
const FieldType& type_of<SlopeReduction>();

}  // namespace contactd

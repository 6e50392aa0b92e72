// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "contactd/fields/fatigue.hpp"
#include "contactd/fields/friction.hpp"
#include "contactd/fields/friction_with_memory.hpp"
#include "contactd/fields/profile_spec.hpp"
#include "contactd/fields/temperature.hpp"
#include "contactd/fields/temperature_friction.hpp"
#include "contactd/fields/wear.hpp"
#include "contactd/wheel_rail_setup.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<Side> = std::to_array<std::string_view>({"left", "right"});
static_assert(static_cast<int>(Side::left) == 0);
static_assert(static_cast<int>(Side::right) == 1);

template <>
inline constexpr auto enum_words<ContactSearch> = std::to_array<std::string_view>({"locus", "mesh"});
static_assert(static_cast<int>(ContactSearch::locus) == 0);
static_assert(static_cast<int>(ContactSearch::mesh) == 1);

template <>
inline constexpr auto enum_words<PatchHistory> = std::to_array<std::string_view>({"own", "whole"});
static_assert(static_cast<int>(PatchHistory::own) == 0);
static_assert(static_cast<int>(PatchHistory::whole) == 1);

template <>
inline constexpr auto enum_words<SliceSpline> =
    std::to_array<std::string_view>({"shape_preserving", "cubic", "approximating"});
static_assert(static_cast<int>(SliceSpline::shape_preserving) == 0);
static_assert(static_cast<int>(SliceSpline::cubic) == 1);
static_assert(static_cast<int>(SliceSpline::approximating) == 2);

template <>
inline constexpr auto enum_words<WheelSurfaceKind> = std::to_array<std::string_view>({"exact", "bilinear"});
static_assert(static_cast<int>(WheelSurfaceKind::exact) == 0);
static_assert(static_cast<int>(WheelSurfaceKind::bilinear) == 1);

template <>
inline constexpr auto enum_words<RigidSlipKind> = std::to_array<std::string_view>({"plane", "surfaces", "elements"});
static_assert(static_cast<int>(RigidSlipKind::plane) == 0);
static_assert(static_cast<int>(RigidSlipKind::surfaces) == 1);
static_assert(static_cast<int>(RigidSlipKind::elements) == 2);

template <>
inline constexpr auto enum_words<SlopeForces> = std::to_array<std::string_view>({"pressure", "all", "none"});
static_assert(static_cast<int>(SlopeForces::pressure) == 0);
static_assert(static_cast<int>(SlopeForces::all) == 1);
static_assert(static_cast<int>(SlopeForces::none) == 2);

template <>
inline constexpr auto enum_words<Conformal> =
    std::to_array<std::string_view>({"off", "half_space", "rotated", "fem", "auto", "rotated_displacements"});
static_assert(static_cast<int>(Conformal::off) == 0);
static_assert(static_cast<int>(Conformal::half_space) == 1);
static_assert(static_cast<int>(Conformal::rotated) == 2);
static_assert(static_cast<int>(Conformal::fem) == 3);
static_assert(static_cast<int>(Conformal::automatic) == 4);
static_assert(static_cast<int>(Conformal::rotated_displacements) == 5);

template <>
const FieldType& type_of<WheelRailFriction>();
template <>
const FieldType& type_of<FrictionAtAngle>();
template <>
const FieldType& type_of<TemperatureFrictionAtAngle>();
template <>
const FieldType& type_of<WheelRailSetup>();
template <>
const FieldType& type_of<RailSlice>();
template <>
const FieldType& type_of<WheelSlice>();
template <>
const FieldType& type_of<Track>();
template <>
const FieldType& type_of<RailSprings>();
template <>
const FieldType& type_of<Wheelset>();
template <>
const FieldType& type_of<PatchRules>();

}  // namespace contactd

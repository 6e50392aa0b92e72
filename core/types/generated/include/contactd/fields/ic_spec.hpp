// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/fields.hpp"
#include "contactd/fields/layers.hpp"
#include "contactd/ic_spec.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<IcSource> = std::to_array<std::string_view>({"analytic", "fem"});
static_assert(static_cast<int>(IcSource::analytic) == 0);
static_assert(static_cast<int>(IcSource::fem) == 1);

template <>
inline constexpr auto enum_words<BodyShape> =
    std::to_array<std::string_view>({"half_space", "block", "layered", "longitudinally_uniform"});
static_assert(static_cast<int>(BodyShape::half_space) == 0);
static_assert(static_cast<int>(BodyShape::block) == 1);
static_assert(static_cast<int>(BodyShape::layered) == 2);
static_assert(static_cast<int>(BodyShape::longitudinally_uniform) == 3);

template <>
inline constexpr auto enum_words<LoadShape> = std::to_array<std::string_view>({"constant", "bilinear"});
static_assert(static_cast<int>(LoadShape::constant) == 0);
static_assert(static_cast<int>(LoadShape::bilinear) == 1);

template <>
inline constexpr auto enum_words<MeshKind> = std::to_array<std::string_view>({"hex", "prism", "adaptive"});
static_assert(static_cast<int>(MeshKind::hex) == 0);
static_assert(static_cast<int>(MeshKind::prism) == 1);
static_assert(static_cast<int>(MeshKind::adaptive) == 2);

template <>
inline constexpr auto enum_words<Diagonal> = std::to_array<std::string_view>({"outward", "across"});
static_assert(static_cast<int>(Diagonal::outward) == 0);
static_assert(static_cast<int>(Diagonal::across) == 1);

template <>
inline constexpr auto enum_words<FarBoundary> = std::to_array<std::string_view>({"clamped", "half_space"});
static_assert(static_cast<int>(FarBoundary::clamped) == 0);
static_assert(static_cast<int>(FarBoundary::half_space) == 1);

template <>
inline constexpr auto enum_words<Sampling> = std::to_array<std::string_view>({"fem", "linear", "linear_nodes"});
static_assert(static_cast<int>(Sampling::fem) == 0);
static_assert(static_cast<int>(Sampling::linear) == 1);
static_assert(static_cast<int>(Sampling::linear_nodes) == 2);

template <>
inline constexpr auto enum_words<Solver> = std::to_array<std::string_view>({"auto", "amg_pcg", "direct"});
static_assert(static_cast<int>(Solver::automatic) == 0);
static_assert(static_cast<int>(Solver::amg_pcg) == 1);
static_assert(static_cast<int>(Solver::direct) == 2);

template <>
inline constexpr auto enum_words<StoppingCriterion> = std::to_array<std::string_view>({"residual", "update"});
static_assert(static_cast<int>(StoppingCriterion::residual) == 0);
static_assert(static_cast<int>(StoppingCriterion::update) == 1);

template <>
const FieldType& type_of<Ics>();
template <>
const FieldType& type_of<LineContactSpec>();
template <>
const FieldType& type_of<FemSpec>();

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "contactd/contact.hpp"
#include "contactd/fields.hpp"
#include "contactd/fields/contact_columns.hpp"
#include "contactd/fields/contact_load.hpp"
#include "contactd/fields/contact_regions.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "contactd/fields/derivatives.hpp"
#include "contactd/fields/fatigue.hpp"
#include "contactd/fields/gap.hpp"
#include "contactd/fields/grid.hpp"
#include "contactd/fields/session.hpp"
#include "contactd/fields/temperature.hpp"
#include "contactd/fields/wear.hpp"

namespace contactd {

template <>
inline constexpr auto enum_words<ErrorSource> = std::to_array<std::string_view>({"hertz", "estimate"});
static_assert(static_cast<int>(ErrorSource::hertz) == 0);
static_assert(static_cast<int>(ErrorSource::estimate) == 1);

template <>
inline constexpr auto enum_words<SolutionField> = std::to_array<std::string_view>(
    {"element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y", "displacement_x", "displacement_y",
     "displacement_z", "flow_x", "flow_y", "yield_stress", "friction_coefficient", "upper_temperature",
     "lower_temperature", "pressure_by_approach"});
static_assert(static_cast<int>(SolutionField::element_division) == 0);
static_assert(static_cast<int>(SolutionField::pressure) == 1);
static_assert(static_cast<int>(SolutionField::traction_x) == 2);
static_assert(static_cast<int>(SolutionField::traction_y) == 3);
static_assert(static_cast<int>(SolutionField::slip_x) == 4);
static_assert(static_cast<int>(SolutionField::slip_y) == 5);
static_assert(static_cast<int>(SolutionField::displacement_x) == 6);
static_assert(static_cast<int>(SolutionField::displacement_y) == 7);
static_assert(static_cast<int>(SolutionField::displacement_z) == 8);
static_assert(static_cast<int>(SolutionField::flow_x) == 9);
static_assert(static_cast<int>(SolutionField::flow_y) == 10);
static_assert(static_cast<int>(SolutionField::yield_stress) == 11);
static_assert(static_cast<int>(SolutionField::friction_coefficient) == 12);
static_assert(static_cast<int>(SolutionField::upper_temperature) == 13);
static_assert(static_cast<int>(SolutionField::lower_temperature) == 14);
static_assert(static_cast<int>(SolutionField::pressure_by_approach) == 15);

template <>
const FieldType& type_of<ContactProblem>();
template <>
const FieldType& type_of<ContactSolution>();
template <>
const FieldType& type_of<Forces>();
template <>
const FieldType& type_of<Areas>();
template <>
const FieldType& type_of<Counts>();
template <>
const FieldType& type_of<ContactEvidence>();
template <>
const FieldType& type_of<Discretisation>();
template <>
const FieldType& type_of<ForceAccuracy>();
template <>
const FieldType& type_of<GridForces>();
template <>
const FieldType& type_of<RollingResistance>();
template <>
const FieldType& type_of<SolverEvidence>();

}  // namespace contactd

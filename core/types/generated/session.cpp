// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/session.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const SessionInfo& all) {
    [[maybe_unused]] const auto& [step_, lease_seconds_, states_, bytes_, grid_, motion_, side_, ics_] = all;
}
[[maybe_unused]] void all_of(const SessionReply& all) {
    [[maybe_unused]] const auto& [session_, lease_seconds_, ics_, bytes_] = all;
}

}  // namespace

template <>
const FieldType& type_of<FrictionFields<ContactProblem>>() {
    static const auto list = std::to_array<Field>({
        fields::field_as<ContactProblem, &ContactProblem::friction, &FrictionLaw::mu>(
            "mu", &custom_type<ElementwiseCoefficient>, {.bounds = {.least = 0, .most = 1000}, .required = true}),
        fields::field_along<ContactProblem, &ContactProblem::friction, &FrictionLaw::kinetic>("kinetic"),
        fields::field_along<ContactProblem, &ContactProblem::friction, &FrictionLaw::layer>("layer"),
        fields::field_along<ContactProblem, &ContactProblem::friction, &FrictionLaw::temperature>("temperature"),
        fields::field_along<ContactProblem, &ContactProblem::motion, fields::alternative<Shift>, &Shift::rigid_shift>(
            "rigid_shift"),
        fields::field_along<ContactProblem, &ContactProblem::motion, fields::alternative<Shift>, &Shift::rotation>(
            "rotation", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "rad"}),
        fields::field_along<ContactProblem, &ContactProblem::motion, fields::alternative<Shift>, &Shift::duration>(
            "duration", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "s"}),
        fields::field_along<ContactProblem, &ContactProblem::motion, fields::alternative<Shift>, &Shift::force>(
            "force"),
        fields::field_along<ContactProblem, &ContactProblem::motion, fields::alternative<Rolling>>("rolling"),
        fields::field_along<ContactProblem, &ContactProblem::rigid_slip>("rigid_slip"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<FrictionFields<StepInput>>() {
    static const auto list = std::to_array<Field>({
        fields::field_as<StepInput, &StepInput::friction, &FrictionLaw::mu>(
            "mu", &custom_type<ElementwiseCoefficient>, {.bounds = {.least = 0, .most = 1000}, .required = true}),
        fields::field_along<StepInput, &StepInput::friction, &FrictionLaw::kinetic>("kinetic"),
        fields::field_along<StepInput, &StepInput::friction, &FrictionLaw::layer>("layer"),
        fields::field_along<StepInput, &StepInput::friction, &FrictionLaw::temperature>("temperature"),
        fields::field_along<StepInput, &StepInput::motion, fields::alternative<Shift>, &Shift::rigid_shift>(
            "rigid_shift"),
        fields::field_along<StepInput, &StepInput::motion, fields::alternative<Shift>, &Shift::rotation>(
            "rotation", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "rad"}),
        fields::field_along<StepInput, &StepInput::motion, fields::alternative<Shift>, &Shift::duration>(
            "duration", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "s"}),
        fields::field_along<StepInput, &StepInput::motion, fields::alternative<Shift>, &Shift::force>("force"),
        fields::field_along<StepInput, &StepInput::motion, fields::alternative<Rolling>>("rolling"),
        fields::field_along<StepInput, &StepInput::rigid_slip>("rigid_slip"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SessionInfo>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SessionInfo::step>("step", {.bounds = {.least = 0}, .required = true}),
        fields::field<&SessionInfo::lease_seconds>(
            "lease_seconds", {.bounds = {.least = 0, .least_excluded = true}, .unit = "s", .required = true}),
        fields::field<&SessionInfo::states>("states", {.bounds = {.least = 0}, .required = true}),
        fields::field<&SessionInfo::bytes>("bytes", {.bounds = {.least = 0}, .required = true}),
        fields::field<&SessionInfo::grid>("grid"),
        fields::field<&SessionInfo::motion>("motion"),
        fields::field<&SessionInfo::side>("side"),
        fields::field<&SessionInfo::ics>("ics", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SessionReply>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SessionReply::session>("session", {.required = true}),
        fields::field<&SessionReply::lease_seconds>(
            "lease_seconds", {.bounds = {.least = 0, .least_excluded = true}, .unit = "s", .required = true}),
        fields::field<&SessionReply::ics>("ics", {.required = true}),
        fields::field<&SessionReply::bytes>("bytes", {.bounds = {.least = 0}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<StepInput>() {
    static const auto list = std::to_array<Field>({
        fields::field<&StepInput::again>("again"),
        fields::field<&StepInput::approach>("approach", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "mm"}),
        fields::field<&StepInput::Fn>("Fn", {.bounds = {.least = 0, .most = 1e+18}, .unit = "N"}),
        fields::field<&StepInput::gap>("gap"),
        fields::field_within<StepInput>("friction", &type_of<FrictionFields<StepInput>>),
        fields::field<&StepInput::derivatives>("derivatives"),
        fields::field<&StepInput::displacements>("displacements"),
        fields::field<&StepInput::fields>("fields"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/session.hpp"

#include <array>

namespace contactd {
template <>
const FieldType& type_of<FrictionFields<ContactProblem>>() {
    static const auto list = std::to_array<Field>({
        fields::field_as<ContactProblem, &ContactProblem::friction, &FrictionLaw::mu>(
            "mu", &custom_type<ElementwiseCoefficient>, {.bounds = {.least = 0, .most = 1000}, .required = true}),
        fields::field_along<ContactProblem, &ContactProblem::friction, &FrictionLaw::kinetic>("kinetic"),
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
const FieldType& type_of<StepInput>() {
    static const auto list = std::to_array<Field>({
        fields::field<&StepInput::again>("again"),
        fields::field<&StepInput::approach>("approach", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "mm"}),
        fields::field<&StepInput::Fn>("Fn", {.bounds = {.least = 0, .most = 1e+18}, .unit = "N"}),
        fields::field<&StepInput::gap>("gap"),
        fields::field_within<StepInput>("friction", &type_of<FrictionFields<StepInput>>),
        fields::field<&StepInput::derivatives>("derivatives"),
        fields::field<&StepInput::fields>("fields"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/ic_table.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const IcEvidence& all) {
    [[maybe_unused]] const auto& [source_, version_, elements_, dofs_, processes_, seconds_, load_cases_, errors_,
                                  errors_estimated_, warnings_, solver_, mesh_, family_nu_, interpolation_error_,
                                  section_, modelling_error_, imported_] = all;
}
[[maybe_unused]] void all_of(const BuildSeconds& all) {
    [[maybe_unused]] const auto& [assembly_, setup_, solve_, total_] = all;
}
[[maybe_unused]] void all_of(const LoadCaseEvidence& all) {
    [[maybe_unused]] const auto& [load_, iterations_, residual_, update_, converged_, seconds_] = all;
}
[[maybe_unused]] void all_of(const IcErrors& all) {
    [[maybe_unused]] const auto& [xx_, yy_, zz_, scaled_xy_, scaled_xz_] = all;
}
[[maybe_unused]] void all_of(const ComponentError& all) {
    [[maybe_unused]] const auto& [origin_, largest_] = all;
}
[[maybe_unused]] void all_of(const SectionEvidence& all) {
    [[maybe_unused]] const auto& [order_, wavenumbers_, error_, mesh_error_, wavenumber_error_, end_error_,
                                  reciprocity_defect_] = all;
}

}  // namespace

template <>
const FieldType& type_of<IcEvidence>() {
    static const auto list = std::to_array<Field>({
        fields::field<&IcEvidence::source>("source", {.required = true}),
        fields::field<&IcEvidence::version>("version", {.required = true}),
        fields::field<&IcEvidence::elements>("elements", {.bounds = {.least = 0}}),
        fields::field<&IcEvidence::dofs>("dofs", {.bounds = {.least = 0}}),
        fields::field<&IcEvidence::processes>("processes", {.bounds = {.least = 1}}),
        fields::field<&IcEvidence::seconds>("seconds"),
        fields::field<&IcEvidence::load_cases>("load_cases"),
        fields::field<&IcEvidence::errors>("errors"),
        fields::field<&IcEvidence::errors_estimated>("errors_estimated"),
        fields::field<&IcEvidence::warnings>("warnings"),
        fields::field<&IcEvidence::solver>("solver"),
        fields::field<&IcEvidence::mesh>("mesh"),
        fields::field<&IcEvidence::family_nu>("family_nu"),
        fields::field<&IcEvidence::interpolation_error>("interpolation_error", {.bounds = {.least = 0}}),
        fields::field<&IcEvidence::section>("section"),
        fields::field<&IcEvidence::modelling_error>("modelling_error", {.bounds = {.least = 0}}),
        fields::field<&IcEvidence::imported>("imported"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<BuildSeconds>() {
    static const auto list = std::to_array<Field>({
        fields::field<&BuildSeconds::assembly>("assembly", {.bounds = {.least = 0}, .unit = "s", .required = true}),
        fields::field<&BuildSeconds::setup>("setup", {.bounds = {.least = 0}, .unit = "s", .required = true}),
        fields::field<&BuildSeconds::solve>("solve", {.bounds = {.least = 0}, .unit = "s", .required = true}),
        fields::field<&BuildSeconds::total>("total", {.bounds = {.least = 0}, .unit = "s", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<LoadCaseEvidence>() {
    static const auto list = std::to_array<Field>({
        fields::field<&LoadCaseEvidence::load>("load", {.required = true}),
        fields::field<&LoadCaseEvidence::iterations>("iterations", {.bounds = {.least = 0}, .required = true}),
        fields::field<&LoadCaseEvidence::residual>("residual", {.bounds = {.least = 0}, .required = true}),
        fields::field<&LoadCaseEvidence::update>("update", {.bounds = {.least = 0}}),
        fields::field<&LoadCaseEvidence::converged>("converged", {.required = true}),
        fields::field<&LoadCaseEvidence::seconds>("seconds", {.bounds = {.least = 0}, .unit = "s", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<IcErrors>() {
    static const auto list = std::to_array<Field>({
        fields::field<&IcErrors::xx>("xx"),
        fields::field<&IcErrors::yy>("yy"),
        fields::field<&IcErrors::zz>("zz"),
        fields::field<&IcErrors::scaled_xy>("scaled_xy", {.bounds = {.least = 0}}),
        fields::field<&IcErrors::scaled_xz>("scaled_xz", {.bounds = {.least = 0}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ComponentError>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ComponentError::origin>("origin", {.required = true}),
        fields::field<&ComponentError::largest>("largest", {.bounds = {.least = 0}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SectionEvidence>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SectionEvidence::order>("order", {.bounds = {.least = 1, .most = 10}, .required = true}),
        fields::field<&SectionEvidence::wavenumbers>("wavenumbers", {.bounds = {.least = 1}, .required = true}),
        fields::field<&SectionEvidence::error>("error", {.bounds = {.least = 0}, .required = true}),
        fields::field<&SectionEvidence::mesh_error>("mesh_error", {.bounds = {.least = 0}, .required = true}),
        fields::field<&SectionEvidence::wavenumber_error>("wavenumber_error",
                                                          {.bounds = {.least = 0}, .required = true}),
        fields::field<&SectionEvidence::end_error>("end_error", {.bounds = {.least = 0}, .required = true}),
        fields::field<&SectionEvidence::reciprocity_defect>("reciprocity_defect",
                                                            {.bounds = {.least = 0}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

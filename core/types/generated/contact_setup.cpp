// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/contact_setup.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const SolverSettings& all) {
    [[maybe_unused]] const auto& [tolerance_, max_iterations_] = all;
}
[[maybe_unused]] void all_of(const SimplifiedSettings& all) {
    [[maybe_unused]] const auto& [slope_, bound_, on_elements_, blended_, coefficients_, k_adhesion_, k_slip_] = all;
}
[[maybe_unused]] void all_of(const SlopeReduction& all) {
    [[maybe_unused]] const auto& [k0_, alpha_, beta_] = all;
}

}  // namespace

template <>
const FieldType& type_of<ContactSettings>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactSettings::normal>("normal"),
        fields::field_within<ContactSettings>("tangential", &type_of<TangentialSettings<ContactSettings>>),
        fields::field<&ContactSettings::outer>("outer"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SolverSettings>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SolverSettings::tolerance>(
            "tolerance", {.bounds = {.least = 0, .most = 1, .least_excluded = true, .most_excluded = true}}),
        fields::field<&SolverSettings::max_iterations>("max_iterations", {.bounds = {.least = 1, .most = 1e+06}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<TangentialSettings<ContactSettings>>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<ContactSettings, &ContactSettings::tangential, &SolverSettings::tolerance>(
            "tolerance", {.bounds = {.least = 0, .most = 1, .least_excluded = true, .most_excluded = true}}),
        fields::field_along<ContactSettings, &ContactSettings::tangential, &SolverSettings::max_iterations>(
            "max_iterations", {.bounds = {.least = 1, .most = 1e+06}}),
        fields::field_along<ContactSettings, &ContactSettings::tangential_solver>("solver"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SimplifiedSettings>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SimplifiedSettings::slope>("slope"),
        fields::field<&SimplifiedSettings::bound>("bound"),
        fields::field<&SimplifiedSettings::on_elements>("on_elements"),
        fields::field<&SimplifiedSettings::blended>("blended"),
        fields::field<&SimplifiedSettings::coefficients>("coefficients"),
        fields::field<&SimplifiedSettings::k_adhesion>("k_adhesion",
                                                       {.bounds = {.least = 0, .most = 1, .least_excluded = true}}),
        fields::field<&SimplifiedSettings::k_slip>("k_slip",
                                                   {.bounds = {.least = 0, .most = 1, .least_excluded = true}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SlopeReduction>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SlopeReduction::k0>("k0", {.bounds = {.least = 0, .most = 1000, .least_excluded = true}}),
        fields::field<&SlopeReduction::alpha>("alpha", {.bounds = {.least = 0, .most = 1000, .least_excluded = true}}),
        fields::field<&SlopeReduction::beta>("beta", {.bounds = {.least = 0, .most = 1e+06}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/contact_setup.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const SolverSettings& all) {
    [[maybe_unused]] const auto& [tolerance_, max_iterations_] = all;
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

}  // namespace contactd

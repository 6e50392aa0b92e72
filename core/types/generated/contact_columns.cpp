// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/contact_columns.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const ContactColumns& all) {
    [[maybe_unused]] const auto& [frames_, direction_, origin_] = all;
}
[[maybe_unused]] void all_of(const Resultant& all) {
    [[maybe_unused]] const auto& [Fx_, Fy_, Fz_, Mx_, My_, Mz_] = all;
}

}  // namespace

template <>
const FieldType& type_of<ContactColumns>() {
    static const auto list = std::to_array<Field>({
        fields::custom_field<&ContactColumns::frames>("frames", {.required = true}),
        fields::field<&ContactColumns::direction>("direction",
                                                  {.bounds = {.least = -1e+06, .most = 1e+06}, .unit = "rad"}),
        fields::field<&ContactColumns::origin>("origin"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Resultant>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Resultant::Fx>("Fx", {.unit = "N", .required = true}),
        fields::field<&Resultant::Fy>("Fy", {.unit = "N", .required = true}),
        fields::field<&Resultant::Fz>("Fz", {.unit = "N", .required = true}),
        fields::field<&Resultant::Mx>("Mx", {.unit = "N mm", .required = true}),
        fields::field<&Resultant::My>("My", {.unit = "N mm", .required = true}),
        fields::field<&Resultant::Mz>("Mz", {.unit = "N mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

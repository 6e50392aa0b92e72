// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/body.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const Viscoelasticity& all) {
    [[maybe_unused]] const auto& [f_, tau_] = all;
}

}  // namespace

template <>
const FieldType& type_of<Viscoelasticity>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Viscoelasticity::f>("f", {.bounds = {.least = 0, .most = 1e+06}, .required = true}),
        fields::field<&Viscoelasticity::tau>("tau",
                                             {.bounds = {.least = 0, .most = 1e+100}, .unit = "s", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

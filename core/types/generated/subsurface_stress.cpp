// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/subsurface_stress.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const LargestStress& all) {
    [[maybe_unused]] const auto& [von_mises_, x_, y_, z_] = all;
}

}  // namespace

template <>
const FieldType& type_of<LargestStress>() {
    static const auto list = std::to_array<Field>({
        fields::field<&LargestStress::von_mises>("von_mises",
                                                 {.bounds = {.least = 0}, .unit = "N/mm^2", .required = true}),
        fields::field<&LargestStress::x>("x", {.unit = "mm", .required = true}),
        fields::field<&LargestStress::y>("y", {.unit = "mm", .required = true}),
        fields::field<&LargestStress::z>("z", {.bounds = {.most = 0}, .unit = "mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

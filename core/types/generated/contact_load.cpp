// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/contact_load.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const SurfaceState& all) {
    [[maybe_unused]] const auto& [pressure_, traction_x_, traction_y_, yield_stress_, friction_coefficient_] = all;
}

}  // namespace

template <>
const FieldType& type_of<SurfaceState>() {
    static const auto list = std::to_array<Field>({
        fields::custom_field<&SurfaceState::pressure>("pressure"),
        fields::custom_field<&SurfaceState::traction_x>("traction_x"),
        fields::custom_field<&SurfaceState::traction_y>("traction_y"),
        fields::custom_field<&SurfaceState::yield_stress>("yield_stress"),
        fields::custom_field<&SurfaceState::friction_coefficient>("friction_coefficient"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

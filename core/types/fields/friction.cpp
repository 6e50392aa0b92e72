// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/friction.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const KineticFriction& all) {
    [[maybe_unused]] const auto& [law_, mu_, slip_velocity_] = all;
}

}  // namespace

template <>
const FieldType& type_of<KineticFriction>() {
    static const auto list = std::to_array<Field>({
        fields::field<&KineticFriction::law>("law"),
        fields::field<&KineticFriction::mu>("mu", {.bounds = {.least = 0, .most = 1000}, .required = true}),
        fields::field<&KineticFriction::slip_velocity>(
            "slip_velocity",
            {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm/s", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

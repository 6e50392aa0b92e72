// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/temperature_friction.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const TemperatureFriction& all) {
    [[maybe_unused]] const auto& [change_, reference_, range_, memory_] = all;
}

}  // namespace

template <>
const FieldType& type_of<TemperatureFriction>() {
    static const auto list = std::to_array<Field>({
        fields::field<&TemperatureFriction::change>("change",
                                                    {.bounds = {.least = -1000, .most = 1000}, .required = true}),
        fields::field<&TemperatureFriction::reference>(
            "reference", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "degC", .required = true}),
        fields::field<&TemperatureFriction::range>(
            "range", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "K", .required = true}),
        fields::field<&TemperatureFriction::memory>("memory"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/friction_with_memory.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const FrictionMemory& all) {
    [[maybe_unused]] const auto& [distance_, least_velocity_] = all;
}

}  // namespace

template <>
const FieldType& type_of<FrictionMemory>() {
    static const auto list = std::to_array<Field>({
        fields::field<&FrictionMemory::distance>(
            "distance",
            {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
        fields::field<&FrictionMemory::least_velocity>(
            "least_velocity", {.bounds = {.least = 0, .most = 1e+12}, .unit = "mm/s", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

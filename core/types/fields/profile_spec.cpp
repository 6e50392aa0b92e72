// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/profile_spec.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const ProfilePoint& all) {
    [[maybe_unused]] const auto& [y_, z_] = all;
}

}  // namespace

template <>
const FieldType& type_of<ProfilePoint>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ProfilePoint::y>("y",
                                        {.bounds = {.least = -10000, .most = 10000}, .unit = "mm", .required = true}),
        fields::field<&ProfilePoint::z>("z",
                                        {.bounds = {.least = -10000, .most = 10000}, .unit = "mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

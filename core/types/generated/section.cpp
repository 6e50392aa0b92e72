// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/section.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const SectionPoint& all) {
    [[maybe_unused]] const auto& [y_, z_] = all;
}

}  // namespace

template <>
const FieldType& type_of<SectionPoint>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SectionPoint::y>("y", {.bounds = {.least = -1e+12, .most = 1e+12}}),
        fields::field<&SectionPoint::z>("z", {.bounds = {.least = -1e+12, .most = 1e+12}}),
    });
    static const FieldType type = fields::tuple_type(list);
    return type;
}

}  // namespace contactd

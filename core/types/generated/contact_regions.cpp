// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/contact_regions.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const Extent& all) {
    [[maybe_unused]] const auto& [from_, to_] = all;
}
[[maybe_unused]] void all_of(const RegionLimits& all) {
    [[maybe_unused]] const auto& [x_, y_] = all;
}
[[maybe_unused]] void all_of(const ContactRegions& all) {
    [[maybe_unused]] const auto& [limits_, shares_] = all;
}

}  // namespace

template <>
const FieldType& type_of<Extent>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Extent::from>("from", {.bounds = {.least = -1e+12, .most = 1e+12}}),
        fields::field<&Extent::to>("to", {.bounds = {.least = -1e+12, .most = 1e+12}}),
    });
    static const FieldType type = fields::tuple_type(list);
    return type;
}

template <>
const FieldType& type_of<RegionLimits>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RegionLimits::x>("x", {.required = true}),
        fields::field<&RegionLimits::y>("y", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactRegions>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactRegions::limits>("limits", {.required = true}),
        fields::field<&ContactRegions::shares>("shares", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

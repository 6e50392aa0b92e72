// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/temperature.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const SurfaceTemperatures& all) {
    [[maybe_unused]] const auto& [upper_temperature_, lower_temperature_, temperature_, warnings_] = all;
}
[[maybe_unused]] void all_of(const ThermalBody& all) {
    [[maybe_unused]] const auto& [bulk_temperature_, conductivity_, heat_capacity_, density_] = all;
}
[[maybe_unused]] void all_of(const ThermalBodies& all) {
    [[maybe_unused]] const auto& [upper_, lower_, plastic_share_] = all;
}
[[maybe_unused]] void all_of(const ContactTemperature& all) {
    [[maybe_unused]] const auto& [largest_, x_, y_, largest_upper_, largest_lower_, rise_, heat_upper_, heat_lower_,
                                  peclet_] = all;
}

}  // namespace

template <>
const FieldType& type_of<SurfaceTemperatures>() {
    static const auto list = std::to_array<Field>({
        fields::custom_field<&SurfaceTemperatures::upper_temperature>("upper_temperature", {.required = true}),
        fields::custom_field<&SurfaceTemperatures::lower_temperature>("lower_temperature", {.required = true}),
        fields::field<&SurfaceTemperatures::temperature>("temperature", {.required = true}),
        fields::field<&SurfaceTemperatures::warnings>("warnings", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ThermalBody>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ThermalBody::bulk_temperature>("bulk_temperature",
                                                      {.bounds = {.least = -273.15, .most = 1e+06}, .unit = "degC"}),
        fields::field<&ThermalBody::conductivity>("conductivity",
                                                  {.bounds = {.least = 0, .most = 1e+12}, .unit = "W/(m K)"}),
        fields::field<&ThermalBody::heat_capacity>("heat_capacity",
                                                   {.bounds = {.least = 1e-12, .most = 1e+12}, .unit = "J/(kg K)"}),
        fields::field<&ThermalBody::density>("density", {.bounds = {.least = 1e-12, .most = 1e+12}, .unit = "kg/m^3"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ThermalBodies>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ThermalBodies::upper>("upper"),
        fields::field<&ThermalBodies::lower>("lower"),
        fields::field<&ThermalBodies::plastic_share>("plastic_share", {.bounds = {.least = 0, .most = 1}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactTemperature>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactTemperature::largest>("largest", {.unit = "degC", .required = true}),
        fields::field<&ContactTemperature::x>("x", {.unit = "mm", .required = true}),
        fields::field<&ContactTemperature::y>("y", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&ContactTemperature::largest_upper>("largest_upper", {.unit = "degC", .required = true}),
        fields::field<&ContactTemperature::largest_lower>("largest_lower", {.unit = "degC", .required = true}),
        fields::field<&ContactTemperature::rise>("rise", {.bounds = {.least = 0}, .unit = "K", .required = true}),
        fields::field<&ContactTemperature::heat_upper>("heat_upper",
                                                       {.bounds = {.least = 0}, .unit = "N mm/s", .required = true}),
        fields::field<&ContactTemperature::heat_lower>("heat_lower",
                                                       {.bounds = {.least = 0}, .unit = "N mm/s", .required = true}),
        fields::field<&ContactTemperature::peclet>("peclet", {.bounds = {.least = 0}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

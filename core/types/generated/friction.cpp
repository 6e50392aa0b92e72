// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/friction.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const KineticFriction& all) {
    [[maybe_unused]] const auto& [law_, mu_, slip_velocity_, start_, second_, memory_] = all;
}
[[maybe_unused]] void all_of(const SecondTerm& all) {
    [[maybe_unused]] const auto& [fall_, slip_velocity_] = all;
}
[[maybe_unused]] void all_of(const InterfacialLayer& all) {
    [[maybe_unused]] const auto& [flexibility_, yield_stress_, hardening_, residual_] = all;
}
[[maybe_unused]] void all_of(const RigidShift& all) {
    [[maybe_unused]] const auto& [x_, y_] = all;
}
[[maybe_unused]] void all_of(const RigidSlip& all) {
    [[maybe_unused]] const auto& [x_, y_] = all;
}
[[maybe_unused]] void all_of(const Force& all) {
    [[maybe_unused]] const auto& [Fx_, Fy_] = all;
}
[[maybe_unused]] void all_of(const Rolling& all) {
    [[maybe_unused]] const auto& [xi_, eta_, phi_, chi_, dq_, spin_offset_, kind_, steps_, velocity_, force_] = all;
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
        fields::field<&KineticFriction::start>("start"),
        fields::field<&KineticFriction::second>("second"),
        fields::field<&KineticFriction::memory>("memory"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SecondTerm>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SecondTerm::fall>("fall", {.bounds = {.least = 0, .most = 1000}, .required = true}),
        fields::field<&SecondTerm::slip_velocity>(
            "slip_velocity",
            {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm/s", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<InterfacialLayer>() {
    static const auto list = std::to_array<Field>({
        fields::field<&InterfacialLayer::flexibility>("flexibility",
                                                      {.bounds = {.least = 0, .most = 1e+06}, .unit = "mm^3/N"}),
        fields::field<&InterfacialLayer::yield_stress>("yield_stress",
                                                       {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true},
                                                        .none = std::numeric_limits<double>::infinity(),
                                                        .unit = "N/mm^2"}),
        fields::field<&InterfacialLayer::hardening>("hardening",
                                                    {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "N/mm^3"}),
        fields::field<&InterfacialLayer::residual>("residual", {.bounds = {.least = 0, .most = 1}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<RigidShift>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RigidShift::x>("x", {.bounds = {.least = -1e+12, .most = 1e+12}}),
        fields::field<&RigidShift::y>("y", {.bounds = {.least = -1e+12, .most = 1e+12}}),
    });
    static const FieldType type = fields::tuple_type(list);
    return type;
}

template <>
const FieldType& type_of<RigidSlip>() {
    static const auto list = std::to_array<Field>({
        fields::custom_field<&RigidSlip::x>("x", {.required = true}),
        fields::custom_field<&RigidSlip::y>("y", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Force>() {
    static const auto list = std::to_array<Field>({
        fields::custom_field<&Force::Fx>("Fx", {.bounds = {.least = -1e+18, .most = 1e+18}}),
        fields::custom_field<&Force::Fy>("Fy", {.bounds = {.least = -1e+18, .most = 1e+18}}),
    });
    static const FieldType type = fields::tuple_type(list);
    return type;
}

template <>
const FieldType& type_of<Rolling>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Rolling::xi>("xi", {.bounds = {.least = -1e+12, .most = 1e+12}}),
        fields::field<&Rolling::eta>("eta", {.bounds = {.least = -1e+12, .most = 1e+12}}),
        fields::field<&Rolling::phi>("phi", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "rad/mm"}),
        fields::field<&Rolling::chi>("chi", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "rad"}),
        fields::field<&Rolling::dq>(
            "dq", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .none = 0, .unit = "mm"}),
        fields::field<&Rolling::spin_offset>("spin_offset", {.bounds = {.least = 0, .most = 1}}),
        fields::field<&Rolling::kind>("kind"),
        fields::field<&Rolling::steps>("steps", {.bounds = {.least = 1, .most = 100000}}),
        fields::field<&Rolling::velocity>(
            "velocity", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm/s"}),
        fields::field<&Rolling::force>("force"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

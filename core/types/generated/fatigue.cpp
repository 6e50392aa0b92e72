// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/fatigue.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const FatigueStrength& all) {
    [[maybe_unused]] const auto& [name_, source_, shear_yield_, a_DV_, tau_e_] = all;
}
[[maybe_unused]] void all_of(const DamageFunction& all) {
    [[maybe_unused]] const auto& [name_, source_, range_, pieces_] = all;
}
[[maybe_unused]] void all_of(const Passage& all) {
    [[maybe_unused]] const auto& [depths_, residual_] = all;
}
[[maybe_unused]] void all_of(const ResidualStress& all) {
    [[maybe_unused]] const auto& [depth_, xx_, yy_] = all;
}
[[maybe_unused]] void all_of(const FatigueRequest& all) {
    [[maybe_unused]] const auto& [body_, strength_, damages_, passage_] = all;
}
[[maybe_unused]] void all_of(const StressPlace& all) {
    [[maybe_unused]] const auto& [value_, y_, z_, depth_] = all;
}
[[maybe_unused]] void all_of(const ContactFatigue& all) {
    [[maybe_unused]] const auto& [body_, T_gamma_, traction_coefficient_, force_angle_, driven_, FI_surf_, FI_sub_,
                                  load_, limit_, shear_, von_mises_, dang_van_, utilisation_, damages_, rows_] = all;
}
[[maybe_unused]] void all_of(const FunctionDamage& all) {
    [[maybe_unused]] const auto& [name_, value_] = all;
}
[[maybe_unused]] void all_of(const FatigueRow& all) {
    [[maybe_unused]] const auto& [y_, z_, angle_, pressure_, traction_, force_x_, force_y_, shear_, shear_depth_,
                                  dang_van_, dang_van_depth_] = all;
}

}  // namespace

template <>
const FieldType& type_of<FatigueStrength>() {
    static const auto list = std::to_array<Field>({
        fields::field<&FatigueStrength::name>("name", {.required = true}),
        fields::field<&FatigueStrength::source>("source", {.required = true}),
        fields::field<&FatigueStrength::shear_yield>(
            "shear_yield",
            {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "N/mm^2", .required = true}),
        fields::field<&FatigueStrength::a_DV>("a_DV", {.bounds = {.least = 0, .most = 1000}}),
        fields::field<&FatigueStrength::tau_e>(
            "tau_e", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "N/mm^2"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<DamageFunction>() {
    static const auto list = std::to_array<Field>({
        fields::field<&DamageFunction::name>("name", {.required = true}),
        fields::field<&DamageFunction::source>("source", {.required = true}),
        fields::field<&DamageFunction::range>("range", {.required = true}),
        fields::field<&DamageFunction::pieces>("pieces", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Passage>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Passage::depths>("depths"),
        fields::field<&Passage::residual>("residual"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ResidualStress>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ResidualStress::depth>("depth",
                                              {.bounds = {.least = 0, .most = 1e+06}, .unit = "mm", .required = true}),
        fields::field<&ResidualStress::xx>(
            "xx", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "N/mm^2", .required = true}),
        fields::field<&ResidualStress::yy>(
            "yy", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "N/mm^2", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<FatigueRequest>() {
    static const auto list = std::to_array<Field>({
        fields::field<&FatigueRequest::body>("body", {.required = true}),
        fields::field<&FatigueRequest::strength>("strength"),
        fields::field<&FatigueRequest::damages>("damages"),
        fields::field<&FatigueRequest::passage>("passage"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<StressPlace>() {
    static const auto list = std::to_array<Field>({
        fields::field<&StressPlace::value>("value", {.unit = "N/mm^2", .required = true}),
        fields::field<&StressPlace::y>("y", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&StressPlace::z>("z", {.unit = "mm", .required = true}),
        fields::field<&StressPlace::depth>("depth", {.bounds = {.least = 0}, .unit = "mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactFatigue>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactFatigue::body>("body", {.required = true}),
        fields::field<&ContactFatigue::T_gamma>("T_gamma", {.unit = "N", .required = true}),
        fields::field<&ContactFatigue::traction_coefficient>("traction_coefficient",
                                                             {.bounds = {.least = 0}, .required = true}),
        fields::field<&ContactFatigue::force_angle>("force_angle",
                                                    {.unit = "rad", .parity = MirrorParity::odd, .required = true}),
        fields::field<&ContactFatigue::driven>("driven", {.required = true}),
        fields::field<&ContactFatigue::FI_surf>("FI_surf"),
        fields::field<&ContactFatigue::FI_sub>("FI_sub", {.unit = "N/mm^2", .required = true}),
        fields::field<&ContactFatigue::load>("load", {.bounds = {.least = 0}}),
        fields::field<&ContactFatigue::limit>("limit", {.bounds = {.least = 0}}),
        fields::field<&ContactFatigue::shear>("shear"),
        fields::field<&ContactFatigue::von_mises>("von_mises"),
        fields::field<&ContactFatigue::dang_van>("dang_van"),
        fields::field<&ContactFatigue::utilisation>("utilisation"),
        fields::field<&ContactFatigue::damages>("damages", {.required = true}),
        fields::field<&ContactFatigue::rows>("rows", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<FunctionDamage>() {
    static const auto list = std::to_array<Field>({
        fields::field<&FunctionDamage::name>("name", {.required = true}),
        fields::field<&FunctionDamage::value>("value", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<FatigueRow>() {
    static const auto list = std::to_array<Field>({
        fields::field<&FatigueRow::y>("y", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&FatigueRow::z>("z", {.unit = "mm", .required = true}),
        fields::field<&FatigueRow::angle>("angle", {.unit = "rad", .parity = MirrorParity::odd, .required = true}),
        fields::field<&FatigueRow::pressure>("pressure", {.bounds = {.least = 0}, .unit = "N/mm^2", .required = true}),
        fields::field<&FatigueRow::traction>("traction", {.bounds = {.least = 0}, .unit = "N/mm^2", .required = true}),
        fields::field<&FatigueRow::force_x>("force_x", {.unit = "N/mm", .required = true}),
        fields::field<&FatigueRow::force_y>("force_y", {.unit = "N/mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&FatigueRow::shear>("shear", {.unit = "N/mm^2"}),
        fields::field<&FatigueRow::shear_depth>("shear_depth", {.unit = "mm"}),
        fields::field<&FatigueRow::dang_van>("dang_van", {.unit = "N/mm^2"}),
        fields::field<&FatigueRow::dang_van_depth>("dang_van_depth", {.unit = "mm"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

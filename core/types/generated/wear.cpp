// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/wear.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const WearPiece& all) {
    [[maybe_unused]] const auto& [from_, value_, slope_] = all;
}
[[maybe_unused]] void all_of(const WearRange& all) {
    [[maybe_unused]] const auto& [least_, most_] = all;
}
[[maybe_unused]] void all_of(const WearLaw& all) {
    [[maybe_unused]] const auto& [name_, source_, body_, range_, archard_, energy_, usfd_, br_, zobory_, zones_] = all;
}
[[maybe_unused]] void all_of(const ArchardWear& all) {
    [[maybe_unused]] const auto& [hardness_, mild_, severe_, seizure_] = all;
}
[[maybe_unused]] void all_of(const SevereWear& all) {
    [[maybe_unused]] const auto& [k_, velocity_] = all;
}
[[maybe_unused]] void all_of(const SeizureWear& all) {
    [[maybe_unused]] const auto& [k_, pressure_] = all;
}
[[maybe_unused]] void all_of(const EnergyWear& all) {
    [[maybe_unused]] const auto& [coefficient_] = all;
}
[[maybe_unused]] void all_of(const UsfdWear& all) {
    [[maybe_unused]] const auto& [pieces_, density_] = all;
}
[[maybe_unused]] void all_of(const BrWear& all) {
    [[maybe_unused]] const auto& [pieces_] = all;
}
[[maybe_unused]] void all_of(const ZoboryWear& all) {
    [[maybe_unused]] const auto& [pieces_, density_] = all;
}
[[maybe_unused]] void all_of(const WearZone& all) {
    [[maybe_unused]] const auto& [angle_, factor_] = all;
}
[[maybe_unused]] void all_of(const WearRequest& all) {
    [[maybe_unused]] const auto& [energy_, laws_] = all;
}
[[maybe_unused]] void all_of(const ContactWear& all) {
    [[maybe_unused]] const auto& [T_gamma_, T_gamma_with_spin_, dissipation_, factor_, largest_pressure_slip_,
                                  largest_dissipation_, largest_sliding_velocity_, rows_, laws_] = all;
}
[[maybe_unused]] void all_of(const WearRow& all) {
    [[maybe_unused]] const auto& [y_, z_, angle_, dissipation_, pressure_slip_, depths_] = all;
}
[[maybe_unused]] void all_of(const LawWear& all) {
    [[maybe_unused]] const auto& [name_, body_, area_, depth_, argument_] = all;
}

}  // namespace

template <>
const FieldType& type_of<WearPiece>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WearPiece::from>("from", {.bounds = {.least = 0, .most = 1e+12}, .required = true}),
        fields::field<&WearPiece::value>("value", {.bounds = {.least = -1e+12, .most = 1e+12}, .required = true}),
        fields::field<&WearPiece::slope>("slope", {.bounds = {.least = -1e+12, .most = 1e+12}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WearRange>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WearRange::least>("least", {.bounds = {.least = 0, .most = 1e+12}}),
        fields::field<&WearRange::most>("most", {.bounds = {.least = 0, .most = 1e+12}}),
    });
    static const FieldType type = fields::tuple_type(list);
    return type;
}

template <>
const FieldType& type_of<WearLaw>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WearLaw::name>("name", {.required = true}),
        fields::field<&WearLaw::source>("source", {.required = true}),
        fields::field<&WearLaw::body>("body", {.required = true}),
        fields::field<&WearLaw::range>("range", {.required = true}),
        fields::field<&WearLaw::archard>("archard"),
        fields::field<&WearLaw::energy>("energy"),
        fields::field<&WearLaw::usfd>("usfd"),
        fields::field<&WearLaw::br>("br"),
        fields::field<&WearLaw::zobory>("zobory"),
        fields::field<&WearLaw::zones>("zones"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ArchardWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ArchardWear::hardness>(
            "hardness", {.bounds = {.least = 1e-12, .most = 1e+12}, .unit = "N/mm^2", .required = true}),
        fields::field<&ArchardWear::mild>("mild", {.bounds = {.least = 0, .most = 1000}, .required = true}),
        fields::field<&ArchardWear::severe>("severe"),
        fields::field<&ArchardWear::seizure>("seizure"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SevereWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SevereWear::k>("k", {.bounds = {.least = 0, .most = 1000}, .required = true}),
        fields::field<&SevereWear::velocity>("velocity", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SeizureWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SeizureWear::k>("k", {.bounds = {.least = 0, .most = 1000}, .required = true}),
        fields::field<&SeizureWear::pressure>("pressure", {.bounds = {.least = 0, .most = 1e+12}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<EnergyWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&EnergyWear::coefficient>(
            "coefficient", {.bounds = {.least = 0, .most = 1e+12}, .unit = "mm^3/J", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<UsfdWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&UsfdWear::pieces>("pieces", {.required = true}),
        fields::field<&UsfdWear::density>(
            "density", {.bounds = {.least = 1e-12, .most = 1e+12}, .unit = "kg/m^3", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<BrWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&BrWear::pieces>("pieces", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ZoboryWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ZoboryWear::pieces>("pieces", {.required = true}),
        fields::field<&ZoboryWear::density>(
            "density", {.bounds = {.least = 1e-12, .most = 1e+12}, .unit = "kg/m^3", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WearZone>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WearZone::angle>(
            "angle",
            {.bounds = {.least = -3.141592653589793, .most = 3.141592653589793}, .unit = "rad", .required = true}),
        fields::field<&WearZone::factor>("factor", {.bounds = {.least = 0, .most = 1e+06}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WearRequest>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WearRequest::energy>("energy"),
        fields::field<&WearRequest::laws>("laws"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactWear::T_gamma>("T_gamma", {.unit = "N", .required = true}),
        fields::field<&ContactWear::T_gamma_with_spin>("T_gamma_with_spin", {.unit = "N", .required = true}),
        fields::field<&ContactWear::dissipation>("dissipation",
                                                 {.bounds = {.least = 0}, .unit = "N", .required = true}),
        fields::field<&ContactWear::factor>("factor", {.bounds = {.least = 0}, .required = true}),
        fields::field<&ContactWear::largest_pressure_slip>(
            "largest_pressure_slip", {.bounds = {.least = 0}, .unit = "N/mm^2", .required = true}),
        fields::field<&ContactWear::largest_dissipation>("largest_dissipation",
                                                         {.bounds = {.least = 0}, .unit = "N/mm^2", .required = true}),
        fields::field<&ContactWear::largest_sliding_velocity>(
            "largest_sliding_velocity", {.bounds = {.least = 0}, .unit = "mm/s", .required = true}),
        fields::field<&ContactWear::rows>("rows", {.required = true}),
        fields::field<&ContactWear::laws>("laws", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WearRow>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WearRow::y>("y", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&WearRow::z>("z", {.unit = "mm", .required = true}),
        fields::field<&WearRow::angle>("angle", {.unit = "rad", .parity = MirrorParity::odd, .required = true}),
        fields::field<&WearRow::dissipation>("dissipation", {.bounds = {.least = 0}, .unit = "N/mm", .required = true}),
        fields::field<&WearRow::pressure_slip>("pressure_slip",
                                               {.bounds = {.least = 0}, .unit = "N/mm", .required = true}),
        fields::field<&WearRow::depths>("depths", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<LawWear>() {
    static const auto list = std::to_array<Field>({
        fields::field<&LawWear::name>("name", {.required = true}),
        fields::field<&LawWear::body>("body", {.required = true}),
        fields::field<&LawWear::area>("area", {.unit = "mm^2", .required = true}),
        fields::field<&LawWear::depth>("depth", {.unit = "mm", .required = true}),
        fields::field<&LawWear::argument>("argument", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

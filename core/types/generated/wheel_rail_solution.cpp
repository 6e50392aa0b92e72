// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/wheel_rail_solution.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const Wrench& all) {
    [[maybe_unused]] const auto& [Fx_, Fy_, Fz_, Mx_, My_, Mz_] = all;
}
[[maybe_unused]] void all_of(const WheelRailForces& all) {
    [[maybe_unused]] const auto& [track_, rail_, wheelset_] = all;
}
[[maybe_unused]] void all_of(const WheelRailDerivatives& all) {
    [[maybe_unused]] const auto& [position_, velocity_] = all;
}
[[maybe_unused]] void all_of(const WheelRailDerivatives::ByPosition& all) {
    [[maybe_unused]] const auto& [y_, z_, roll_, yaw_] = all;
}
[[maybe_unused]] void all_of(const WheelRailDerivatives::ByVelocity& all) {
    [[maybe_unused]] const auto& [x_, y_, z_, roll_, yaw_, pitch_] = all;
}
[[maybe_unused]] void all_of(const ProfileFrame& all) {
    [[maybe_unused]] const auto& [x_, y_, z_, roll_, yaw_] = all;
}
[[maybe_unused]] void all_of(const ContactReference& all) {
    [[maybe_unused]] const auto& [x_, y_, z_, angle_] = all;
}
[[maybe_unused]] void all_of(const ContactPlace& all) {
    [[maybe_unused]] const auto& [reference_, on_rail_, regions_, shares_, grid_, approach_, penetration_, creepages_,
                                  radii_, rows_] = all;
}
[[maybe_unused]] void all_of(const RailPlace& all) {
    [[maybe_unused]] const auto& [along_, across_] = all;
}
[[maybe_unused]] void all_of(const OverlapRegion& all) {
    [[maybe_unused]] const auto& [reference_, x_, y_, z_, penetration_, size_] = all;
}
[[maybe_unused]] void all_of(const Creepages& all) {
    [[maybe_unused]] const auto& [xi_, eta_, phi_, chi_, velocity_] = all;
}
[[maybe_unused]] void all_of(const ContactRadii& all) {
    [[maybe_unused]] const auto& [wheel_along_, wheel_across_, rail_along_, rail_across_] = all;
}
[[maybe_unused]] void all_of(const ContactRow& all) {
    [[maybe_unused]] const auto& [y_, z_, angle_] = all;
}
[[maybe_unused]] void all_of(const WheelRailGeometry& all) {
    [[maybe_unused]] const auto& [z_, wheel_frame_, rail_frame_, clearance_, places_, warnings_] = all;
}
[[maybe_unused]] void all_of(const WheelRailSolution& all) {
    [[maybe_unused]] const auto& [z_, pitch_rate_, wheel_frame_, rail_frame_, forces_, patches_, warnings_, clearance_,
                                  force_, pitch_search_, rail_deflection_, rail_search_, accuracy_, derivatives_,
                                  left_out_] = all;
}
[[maybe_unused]] void all_of(const WheelRailPatch& all) {
    [[maybe_unused]] const auto& [place_, gap_, solution_, forces_] = all;
}
[[maybe_unused]] void all_of(const RailDeflection& all) {
    [[maybe_unused]] const auto& [y_, z_] = all;
}
[[maybe_unused]] void all_of(const WheelsetSolution& all) {
    [[maybe_unused]] const auto& [z_, roll_, left_, right_, roll_search_, warnings_] = all;
}

}  // namespace

template <>
const FieldType& type_of<Wrench>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Wrench::Fx>("Fx", {.unit = "N", .required = true}),
        fields::field<&Wrench::Fy>("Fy", {.unit = "N", .parity = MirrorParity::odd, .required = true}),
        fields::field<&Wrench::Fz>("Fz", {.unit = "N", .required = true}),
        fields::field<&Wrench::Mx>("Mx", {.unit = "N mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&Wrench::My>("My", {.unit = "N mm", .required = true}),
        fields::field<&Wrench::Mz>("Mz", {.unit = "N mm", .parity = MirrorParity::odd, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelRailForces>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailForces::track>("track", {.required = true}),
        fields::field<&WheelRailForces::rail>("rail", {.required = true}),
        fields::field<&WheelRailForces::wheelset>("wheelset", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelRailDerivatives>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailDerivatives::position>("position", {.required = true}),
        fields::field<&WheelRailDerivatives::velocity>("velocity", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelRailDerivatives::ByPosition>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailDerivatives::ByPosition::y>("y", {.parity = MirrorParity::odd, .required = true}),
        fields::field<&WheelRailDerivatives::ByPosition::z>("z", {.required = true}),
        fields::field<&WheelRailDerivatives::ByPosition::roll>("roll", {.parity = MirrorParity::odd, .required = true}),
        fields::field<&WheelRailDerivatives::ByPosition::yaw>("yaw", {.parity = MirrorParity::odd, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelRailDerivatives::ByVelocity>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailDerivatives::ByVelocity::x>("x", {.required = true}),
        fields::field<&WheelRailDerivatives::ByVelocity::y>("y", {.parity = MirrorParity::odd, .required = true}),
        fields::field<&WheelRailDerivatives::ByVelocity::z>("z", {.required = true}),
        fields::field<&WheelRailDerivatives::ByVelocity::roll>("roll", {.parity = MirrorParity::odd, .required = true}),
        fields::field<&WheelRailDerivatives::ByVelocity::yaw>("yaw", {.parity = MirrorParity::odd, .required = true}),
        fields::field<&WheelRailDerivatives::ByVelocity::pitch>("pitch", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ProfileFrame>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ProfileFrame::x>("x", {.unit = "mm", .required = true}),
        fields::field<&ProfileFrame::y>("y", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&ProfileFrame::z>("z", {.unit = "mm", .required = true}),
        fields::field<&ProfileFrame::roll>("roll", {.unit = "rad", .parity = MirrorParity::odd, .required = true}),
        fields::field<&ProfileFrame::yaw>("yaw", {.unit = "rad", .parity = MirrorParity::odd, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactReference>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactReference::x>("x", {.unit = "mm", .required = true}),
        fields::field<&ContactReference::y>("y", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&ContactReference::z>("z", {.unit = "mm", .required = true}),
        fields::field<&ContactReference::angle>("angle",
                                                {.unit = "rad", .parity = MirrorParity::odd, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactPlace>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactPlace::reference>("reference", {.required = true}),
        fields::field<&ContactPlace::on_rail>("on_rail", {.required = true}),
        fields::field<&ContactPlace::regions>("regions", {.required = true}),
        fields::field<&ContactPlace::shares>("shares", {.required = true}),
        fields::field<&ContactPlace::grid>("grid", {.required = true}),
        fields::field<&ContactPlace::approach>("approach", {.unit = "mm", .required = true}),
        fields::field<&ContactPlace::penetration>("penetration", {.unit = "mm", .required = true}),
        fields::field<&ContactPlace::creepages>("creepages", {.required = true}),
        fields::field<&ContactPlace::radii>("radii", {.required = true}),
        fields::field<&ContactPlace::rows>("rows"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<RailPlace>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RailPlace::along>("along", {.unit = "mm", .required = true}),
        fields::field<&RailPlace::across>("across", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<OverlapRegion>() {
    static const auto list = std::to_array<Field>({
        fields::field<&OverlapRegion::reference>("reference", {.required = true}),
        fields::field<&OverlapRegion::x>("x", {.required = true}),
        fields::field<&OverlapRegion::y>("y", {.required = true}),
        fields::field<&OverlapRegion::z>("z", {.required = true}),
        fields::field<&OverlapRegion::penetration>("penetration", {.unit = "mm", .required = true}),
        fields::field<&OverlapRegion::size>("size", {.unit = "mm^4", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Creepages>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Creepages::xi>("xi", {.required = true}),
        fields::field<&Creepages::eta>("eta", {.parity = MirrorParity::odd, .required = true}),
        fields::field<&Creepages::phi>("phi", {.unit = "rad/mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&Creepages::chi>("chi", {.unit = "rad", .required = true}),
        fields::field<&Creepages::velocity>("velocity", {.unit = "mm/s", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactRadii>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactRadii::wheel_along>("wheel_along",
                                                  {.none = std::numeric_limits<double>::infinity(), .unit = "mm"}),
        fields::field<&ContactRadii::wheel_across>("wheel_across",
                                                   {.none = std::numeric_limits<double>::infinity(), .unit = "mm"}),
        fields::field<&ContactRadii::rail_along>("rail_along",
                                                 {.none = std::numeric_limits<double>::infinity(), .unit = "mm"}),
        fields::field<&ContactRadii::rail_across>("rail_across",
                                                  {.none = std::numeric_limits<double>::infinity(), .unit = "mm"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactRow>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactRow::y>("y", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&ContactRow::z>("z", {.unit = "mm", .required = true}),
        fields::field<&ContactRow::angle>("angle", {.unit = "rad", .parity = MirrorParity::odd, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelRailGeometry>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailGeometry::z>("z", {.unit = "mm", .required = true}),
        fields::field<&WheelRailGeometry::wheel_frame>("wheel_frame", {.required = true}),
        fields::field<&WheelRailGeometry::rail_frame>("rail_frame", {.required = true}),
        fields::field<&WheelRailGeometry::clearance>("clearance", {.unit = "mm"}),
        fields::field<&WheelRailGeometry::places>("places", {.required = true}),
        fields::field<&WheelRailGeometry::warnings>("warnings", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelRailSolution>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailSolution::z>("z", {.unit = "mm", .required = true}),
        fields::field<&WheelRailSolution::pitch_rate>("pitch_rate", {.unit = "rad/s", .required = true}),
        fields::field<&WheelRailSolution::wheel_frame>("wheel_frame", {.required = true}),
        fields::field<&WheelRailSolution::rail_frame>("rail_frame", {.required = true}),
        fields::field<&WheelRailSolution::forces>("forces", {.required = true}),
        fields::field<&WheelRailSolution::patches>("patches"),
        fields::field<&WheelRailSolution::warnings>("warnings", {.required = true}),
        fields::field<&WheelRailSolution::clearance>("clearance", {.unit = "mm"}),
        fields::field<&WheelRailSolution::force>("force"),
        fields::field<&WheelRailSolution::pitch_search>("pitch_search"),
        fields::field<&WheelRailSolution::rail_deflection>("rail_deflection"),
        fields::field<&WheelRailSolution::rail_search>("rail_search"),
        fields::field<&WheelRailSolution::accuracy>("accuracy", {.bounds = {.least = 0}}),
        fields::field<&WheelRailSolution::derivatives>("derivatives"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelRailPatch>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailPatch::place>("place", {.required = true}),
        fields::custom_field<&WheelRailPatch::gap>("gap"),
        fields::field<&WheelRailPatch::solution>("solution", {.required = true}),
        fields::field<&WheelRailPatch::forces>("forces", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<RailDeflection>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RailDeflection::y>("y", {.unit = "mm", .parity = MirrorParity::odd, .required = true}),
        fields::field<&RailDeflection::z>("z", {.unit = "mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelsetSolution>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelsetSolution::z>("z", {.unit = "mm", .required = true}),
        fields::field<&WheelsetSolution::roll>("roll", {.unit = "rad", .required = true}),
        fields::field<&WheelsetSolution::left>("left", {.required = true}),
        fields::field<&WheelsetSolution::right>("right", {.required = true}),
        fields::field<&WheelsetSolution::roll_search>("roll_search", {.required = true}),
        fields::field<&WheelsetSolution::warnings>("warnings", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

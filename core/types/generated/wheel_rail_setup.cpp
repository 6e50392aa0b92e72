// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/wheel_rail_setup.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const WheelRailFriction& all) {
    [[maybe_unused]] const auto& [mu_, along_profile_, kinetic_, layer_, temperature_, temperature_by_angle_, memory_] =
        all;
}
[[maybe_unused]] void all_of(const FrictionAtAngle& all) {
    [[maybe_unused]] const auto& [angle_, mu_] = all;
}
[[maybe_unused]] void all_of(const TemperatureFrictionAtAngle& all) {
    [[maybe_unused]] const auto& [angle_, change_, reference_, range_] = all;
}
[[maybe_unused]] void all_of(const WheelRailSetup& all) {
    [[maybe_unused]] const auto& [side_, wheel_, rail_, rail_slices_, wheel_slices_, track_, wheelset_, bodies_, model_,
                                  normal_model_, simplified_, temperature_, wear_, fatigue_, sheet_flexibility_,
                                  friction_, dx_, dy_, dq_, patches_, rail_spline_, wheel_spline_, wheel_surface_,
                                  rigid_slip_, slope_forces_, conformal_, settings_, force_, accuracy_] = all;
}
[[maybe_unused]] void all_of(const RailSlice& all) {
    [[maybe_unused]] const auto& [x_, profile_, features_] = all;
}
[[maybe_unused]] void all_of(const WheelSlice& all) {
    [[maybe_unused]] const auto& [angle_, profile_] = all;
}
[[maybe_unused]] void all_of(const Track& all) {
    [[maybe_unused]] const auto& [gauge_, gauge_height_, cant_, rail_origin_, roller_radius_, roller_leans_, springs_] =
        all;
}
[[maybe_unused]] void all_of(const RailSprings& all) {
    [[maybe_unused]] const auto& [y_, z_] = all;
}
[[maybe_unused]] void all_of(const Wheelset& all) {
    [[maybe_unused]] const auto& [flange_back_distance_, flange_back_position_, nominal_radius_] = all;
}
[[maybe_unused]] void all_of(const PatchRules& all) {
    [[maybe_unused]] const auto& [angle_separate_, distance_separate_, distance_combine_, distance_turn_, locus_step_,
                                  search_, history_, max_elements_] = all;
}

}  // namespace

template <>
const FieldType& type_of<WheelRailFriction>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailFriction::mu>("mu"),
        fields::field<&WheelRailFriction::along_profile>("along_profile"),
        fields::field<&WheelRailFriction::kinetic>("kinetic"),
        fields::field<&WheelRailFriction::layer>("layer"),
        fields::field<&WheelRailFriction::temperature>("temperature"),
        fields::field<&WheelRailFriction::temperature_by_angle>("temperature_by_angle"),
        fields::field<&WheelRailFriction::memory>("memory"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<FrictionAtAngle>() {
    static const auto list = std::to_array<Field>({
        fields::field<&FrictionAtAngle::angle>(
            "angle",
            {.bounds = {.least = -3.141592653589793, .most = 3.141592653589793}, .unit = "rad", .required = true}),
        fields::field<&FrictionAtAngle::mu>("mu", {.bounds = {.least = 0, .most = 1000}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<TemperatureFrictionAtAngle>() {
    static const auto list = std::to_array<Field>({
        fields::field<&TemperatureFrictionAtAngle::angle>(
            "angle",
            {.bounds = {.least = -3.141592653589793, .most = 3.141592653589793}, .unit = "rad", .required = true}),
        fields::field<&TemperatureFrictionAtAngle::change>(
            "change", {.bounds = {.least = -1000, .most = 1000}, .required = true}),
        fields::field<&TemperatureFrictionAtAngle::reference>(
            "reference", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "degC", .required = true}),
        fields::field<&TemperatureFrictionAtAngle::range>(
            "range", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "K", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelRailSetup>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailSetup::side>("side"),
        fields::field<&WheelRailSetup::wheel>("wheel"),
        fields::field<&WheelRailSetup::rail>("rail"),
        fields::field<&WheelRailSetup::rail_slices>("rail_slices"),
        fields::field<&WheelRailSetup::wheel_slices>("wheel_slices"),
        fields::field<&WheelRailSetup::track>("track"),
        fields::field<&WheelRailSetup::wheelset>("wheelset"),
        fields::custom_field<&WheelRailSetup::bodies>("bodies"),
        fields::field<&WheelRailSetup::model>("model"),
        fields::field<&WheelRailSetup::normal_model>("normal_model"),
        fields::field<&WheelRailSetup::simplified>("simplified"),
        fields::field<&WheelRailSetup::temperature>("temperature"),
        fields::field<&WheelRailSetup::wear>("wear"),
        fields::field<&WheelRailSetup::fatigue>("fatigue"),
        fields::field<&WheelRailSetup::sheet_flexibility>("sheet_flexibility",
                                                          {.bounds = {.least = 0, .most = 1e+06}, .unit = "mm^3/N"}),
        fields::field<&WheelRailSetup::friction>("friction"),
        fields::field<&WheelRailSetup::dx>("dx", {.bounds = {.least = 0.0001, .most = 100}, .unit = "mm"}),
        fields::field<&WheelRailSetup::dy>("dy", {.bounds = {.least = 0.0001, .most = 100}, .unit = "mm"}),
        fields::field<&WheelRailSetup::dq>("dq", {.bounds = {.least = 0, .most = 100}, .unit = "mm"}),
        fields::field<&WheelRailSetup::patches>("patches"),
        fields::field<&WheelRailSetup::rail_spline>("rail_spline"),
        fields::field<&WheelRailSetup::wheel_spline>("wheel_spline"),
        fields::field<&WheelRailSetup::wheel_surface>("wheel_surface"),
        fields::field<&WheelRailSetup::rigid_slip>("rigid_slip"),
        fields::field<&WheelRailSetup::slope_forces>("slope_forces"),
        fields::field<&WheelRailSetup::conformal>("conformal"),
        fields::field<&WheelRailSetup::settings>("settings"),
        fields::field<&WheelRailSetup::force>("force"),
        fields::field<&WheelRailSetup::accuracy>("accuracy", {.bounds = {.least = 1e-08, .most = 0.01}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<RailSlice>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RailSlice::x>("x", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm", .required = true}),
        fields::field<&RailSlice::profile>("profile", {.required = true}),
        fields::field<&RailSlice::features>("features"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelSlice>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelSlice::angle>(
            "angle",
            {.bounds = {.least = -6.283185307179586, .most = 6.283185307179586}, .unit = "rad", .required = true}),
        fields::field<&WheelSlice::profile>("profile", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Track>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Track::gauge>("gauge",
                                     {.bounds = {.least = 0, .most = 10000, .least_excluded = true}, .unit = "mm"}),
        fields::field<&Track::gauge_height>("gauge_height", {.bounds = {.least = 0, .most = 10000}, .unit = "mm"}),
        fields::field<&Track::cant>("cant", {.bounds = {.least = -0.5, .most = 0.5}, .unit = "rad"}),
        fields::field<&Track::rail_origin>("rail_origin"),
        fields::field<&Track::roller_radius>(
            "roller_radius", {.bounds = {.least = 0, .most = 1e+07, .least_excluded = true}, .unit = "mm"}),
        fields::field<&Track::roller_leans>("roller_leans"),
        fields::field<&Track::springs>("springs"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<RailSprings>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RailSprings::y>("y", {.bounds = {.least = 0.001, .most = 1e+10}, .unit = "N/mm"}),
        fields::field<&RailSprings::z>("z", {.bounds = {.least = 0.001, .most = 1e+10}, .unit = "N/mm"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Wheelset>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Wheelset::flange_back_distance>(
            "flange_back_distance", {.bounds = {.least = 0, .most = 10000, .least_excluded = true}, .unit = "mm"}),
        fields::field<&Wheelset::flange_back_position>("flange_back_position",
                                                       {.bounds = {.least = -10000, .most = 10000}, .unit = "mm"}),
        fields::field<&Wheelset::nominal_radius>(
            "nominal_radius", {.bounds = {.least = 0, .most = 10000, .least_excluded = true}, .unit = "mm"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<PatchRules>() {
    static const auto list = std::to_array<Field>({
        fields::field<&PatchRules::angle_separate>(
            "angle_separate",
            {.bounds = {.least = 0, .most = 3.141592653589793, .least_excluded = true}, .unit = "rad"}),
        fields::field<&PatchRules::distance_separate>(
            "distance_separate", {.bounds = {.least = 0, .most = 10000, .least_excluded = true}, .unit = "mm"}),
        fields::field<&PatchRules::distance_combine>(
            "distance_combine", {.bounds = {.least = 0, .most = 10000, .least_excluded = true}, .unit = "mm"}),
        fields::field<&PatchRules::distance_turn>(
            "distance_turn", {.bounds = {.least = 0, .most = 10000, .least_excluded = true}, .unit = "mm"}),
        fields::field<&PatchRules::locus_step>("locus_step",
                                               {.bounds = {.least = 0, .most = 1, .least_excluded = true}}),
        fields::field<&PatchRules::search>("search"),
        fields::field<&PatchRules::history>("history"),
        fields::field<&PatchRules::max_elements>("max_elements", {.bounds = {.least = 0, .most = 1e+09}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

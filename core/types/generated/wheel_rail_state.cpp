// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/wheel_rail_state.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const WheelRailState& all) {
    [[maybe_unused]] const auto& [position_, velocity_, wheel_, rail_, roller_pitch_, Fz_, Fx_, motion_, time_step_,
                                  derivatives_, displacements_] = all;
}
[[maybe_unused]] void all_of(const WheelsetPosition& all) {
    [[maybe_unused]] const auto& [y_, z_, roll_, yaw_, x_, pitch_] = all;
}
[[maybe_unused]] void all_of(const WheelsetVelocity& all) {
    [[maybe_unused]] const auto& [x_, y_, z_, roll_, yaw_, pitch_] = all;
}
[[maybe_unused]] void all_of(const WheelDeviation& all) {
    [[maybe_unused]] const auto& [x_, y_, z_, roll_, yaw_, pitch_, x_velocity_, y_velocity_, z_velocity_,
                                  roll_velocity_, yaw_velocity_, pitch_velocity_] = all;
}
[[maybe_unused]] void all_of(const RailDeviation& all) {
    [[maybe_unused]] const auto& [y_, z_, roll_, y_velocity_, z_velocity_, roll_velocity_, Fy_, Fz_] = all;
}
[[maybe_unused]] void all_of(const WheelsetState& all) {
    [[maybe_unused]] const auto& [position_, velocity_, left_wheel_, right_wheel_, left_rail_, right_rail_,
                                  roller_pitch_, Fz_left_, Fz_right_] = all;
}

}  // namespace

template <>
const FieldType& type_of<WheelRailState>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelRailState::position>("position"),
        fields::field<&WheelRailState::velocity>("velocity"),
        fields::field<&WheelRailState::wheel>("wheel"),
        fields::field<&WheelRailState::rail>("rail"),
        fields::field<&WheelRailState::roller_pitch>("roller_pitch",
                                                     {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s"}),
        fields::field<&WheelRailState::Fz>("Fz", {.bounds = {.least = 1e-06, .most = 1e+18}, .unit = "N"}),
        fields::field<&WheelRailState::Fx>("Fx", {.bounds = {.least = -1e+18, .most = 1e+18}, .unit = "N"}),
        fields::field<&WheelRailState::motion>("motion"),
        fields::field<&WheelRailState::time_step>("time_step",
                                                  {.bounds = {.least = 1e-30, .most = 1e+09}, .unit = "s"}),
        fields::field<&WheelRailState::derivatives>("derivatives"),
        fields::field<&WheelRailState::displacements>("displacements"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelsetPosition>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelsetPosition::y>(
            "y", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm", .parity = MirrorParity::odd}),
        fields::field<&WheelsetPosition::z>("z", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm"}),
        fields::field<&WheelsetPosition::roll>(
            "roll", {.bounds = {.least = -0.5, .most = 0.5}, .unit = "rad", .parity = MirrorParity::odd}),
        fields::field<&WheelsetPosition::yaw>(
            "yaw", {.bounds = {.least = -0.5, .most = 0.5}, .unit = "rad", .parity = MirrorParity::odd}),
        fields::field<&WheelsetPosition::x>("x", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm"}),
        fields::field<&WheelsetPosition::pitch>("pitch", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelsetVelocity>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelsetVelocity::x>("x", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm/s"}),
        fields::field<&WheelsetVelocity::y>(
            "y", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm/s", .parity = MirrorParity::odd}),
        fields::field<&WheelsetVelocity::z>("z", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm/s"}),
        fields::field<&WheelsetVelocity::roll>(
            "roll", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s", .parity = MirrorParity::odd}),
        fields::field<&WheelsetVelocity::yaw>(
            "yaw", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s", .parity = MirrorParity::odd}),
        fields::field<&WheelsetVelocity::pitch>("pitch", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelDeviation>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelDeviation::x>("x", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm"}),
        fields::field<&WheelDeviation::y>(
            "y", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm", .parity = MirrorParity::odd}),
        fields::field<&WheelDeviation::z>("z", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm"}),
        fields::field<&WheelDeviation::roll>(
            "roll", {.bounds = {.least = -0.5, .most = 0.5}, .unit = "rad", .parity = MirrorParity::odd}),
        fields::field<&WheelDeviation::yaw>(
            "yaw", {.bounds = {.least = -0.5, .most = 0.5}, .unit = "rad", .parity = MirrorParity::odd}),
        fields::field<&WheelDeviation::pitch>("pitch", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad"}),
        fields::field<&WheelDeviation::x_velocity>("x_velocity",
                                                   {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm/s"}),
        fields::field<&WheelDeviation::y_velocity>(
            "y_velocity", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm/s", .parity = MirrorParity::odd}),
        fields::field<&WheelDeviation::z_velocity>("z_velocity",
                                                   {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm/s"}),
        fields::field<&WheelDeviation::roll_velocity>(
            "roll_velocity",
            {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s", .parity = MirrorParity::odd}),
        fields::field<&WheelDeviation::yaw_velocity>(
            "yaw_velocity", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s", .parity = MirrorParity::odd}),
        fields::field<&WheelDeviation::pitch_velocity>("pitch_velocity",
                                                       {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<RailDeviation>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RailDeviation::y>(
            "y", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm", .parity = MirrorParity::odd}),
        fields::field<&RailDeviation::z>("z", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm"}),
        fields::field<&RailDeviation::roll>(
            "roll", {.bounds = {.least = -0.5, .most = 0.5}, .unit = "rad", .parity = MirrorParity::odd}),
        fields::field<&RailDeviation::y_velocity>(
            "y_velocity", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm/s", .parity = MirrorParity::odd}),
        fields::field<&RailDeviation::z_velocity>("z_velocity",
                                                  {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "mm/s"}),
        fields::field<&RailDeviation::roll_velocity>(
            "roll_velocity",
            {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s", .parity = MirrorParity::odd}),
        fields::field<&RailDeviation::Fy>(
            "Fy", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "N", .parity = MirrorParity::odd}),
        fields::field<&RailDeviation::Fz>("Fz", {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "N"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelsetState>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelsetState::position>("position"),
        fields::field<&WheelsetState::velocity>("velocity"),
        fields::field<&WheelsetState::left_wheel>("left_wheel"),
        fields::field<&WheelsetState::right_wheel>("right_wheel"),
        fields::field<&WheelsetState::left_rail>("left_rail"),
        fields::field<&WheelsetState::right_rail>("right_rail"),
        fields::field<&WheelsetState::roller_pitch>("roller_pitch",
                                                    {.bounds = {.least = -1e+09, .most = 1e+09}, .unit = "rad/s"}),
        fields::field<&WheelsetState::Fz_left>(
            "Fz_left", {.bounds = {.least = 1e-06, .most = 1e+18}, .unit = "N", .required = true}),
        fields::field<&WheelsetState::Fz_right>(
            "Fz_right", {.bounds = {.least = 1e-06, .most = 1e+18}, .unit = "N", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

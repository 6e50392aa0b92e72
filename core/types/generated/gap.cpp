// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/gap.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const Paraboloid& all) {
    [[maybe_unused]] const auto& [Rx_, Ry_] = all;
}
[[maybe_unused]] void all_of(const SemiAxes& all) {
    [[maybe_unused]] const auto& [a_, b_] = all;
}
[[maybe_unused]] void all_of(const HalfEllipses& all) {
    [[maybe_unused]] const auto& [a_, b_negative_, b_positive_] = all;
}

}  // namespace

template <>
const FieldType& type_of<Gap>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<Gap, fields::alternative<Paraboloid>>("paraboloid"),
        fields::field_along<Gap, fields::alternative<SemiAxes>>("semi_axes"),
        fields::field_along<Gap, fields::alternative<HalfEllipses>>("half_ellipses"),
        fields::custom_field_along<Gap, fields::alternative<std::vector<double>>>("array"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Paraboloid>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Paraboloid::Rx>("Rx", {.bounds = {.least = -1e+12, .most = 1e+12},
                                              .none = std::numeric_limits<double>::infinity(),
                                              .unit = "mm"}),
        fields::field<&Paraboloid::Ry>("Ry", {.bounds = {.least = -1e+12, .most = 1e+12},
                                              .none = std::numeric_limits<double>::infinity(),
                                              .unit = "mm"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SemiAxes>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SemiAxes::a>(
            "a", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
        fields::field<&SemiAxes::b>(
            "b", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<HalfEllipses>() {
    static const auto list = std::to_array<Field>({
        fields::field<&HalfEllipses::a>(
            "a", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
        fields::field<&HalfEllipses::b_negative>(
            "b_negative",
            {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
        fields::field<&HalfEllipses::b_positive>(
            "b_positive",
            {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

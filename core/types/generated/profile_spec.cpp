// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/profile_spec.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const Rail60E1& all) {
    [[maybe_unused]] const auto& [inclination_] = all;
}
[[maybe_unused]] void all_of(const StandardProfile& all) {
    [[maybe_unused]] const auto& [name_, inclination_] = all;
}
[[maybe_unused]] void all_of(const ProfileFile& all) {
    [[maybe_unused]] const auto& [name_, text_, unit_, mirror_y_, mirror_z_, shift_y_, shift_z_, smoothing_length_,
                                  smoothing_order_, smoothing_lambda_, kinks_] = all;
}
[[maybe_unused]] void all_of(const KinkRule& all) {
    [[maybe_unused]] const auto& [angle_, rest_, width_] = all;
}
[[maybe_unused]] void all_of(const ProfilePoint& all) {
    [[maybe_unused]] const auto& [y_, z_] = all;
}

}  // namespace

template <>
const FieldType& type_of<ProfileSpec>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<S1002>>(
            "s1002", {.bounds = {.least = 1, .most = 1}}),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<Rail60E1>>("rail_60e1"),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<ArcProfile>>("arc"),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<ConeProfile>>("cone"),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<StandardProfile>>("standard"),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<ProfilePoints>,
                            &ProfilePoints::points>("points"),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<ProfilePoints>, &ProfilePoints::unit>(
            "unit", {.bounds = {.least = 1e-06, .most = 1e+06}}),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<ProfilePoints>,
                            &ProfilePoints::mirror_y>("mirror_y"),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<ProfilePoints>,
                            &ProfilePoints::mirror_z>("mirror_z"),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<ProfilePoints>,
                            &ProfilePoints::smoothing_length>("smoothing_length",
                                                              {.bounds = {.least = 0, .most = 1000}, .unit = "mm"}),
        fields::field_along<ProfileSpec, &ProfileSpec::shape, fields::alternative<ProfileFile>>("file"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Rail60E1>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Rail60E1::inclination>("inclination", {.bounds = {.least = -0.2, .most = 0.2}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ArcProfile>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<ArcProfile, &ArcProfile::radius>(
            "radius", {.bounds = {.least = -100000, .most = 100000}, .unit = "mm", .required = true}),
        fields::field_along<ArcProfile, &ArcProfile::slope>("slope", {.bounds = {.least = -3, .most = 3}}),
        fields::field_within<ArcProfile>("ends", &type_of<ProfileEnds<ArcProfile>>),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ProfileEnds<ArcProfile>>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<ArcProfile, &ArcProfile::from>("from", {.bounds = {.least = -1000, .most = 1000}}),
        fields::field_along<ArcProfile, &ArcProfile::to>("to", {.bounds = {.least = -1000, .most = 1000}}),
    });
    static const FieldType type = fields::tuple_type(list);
    return type;
}

template <>
const FieldType& type_of<ProfileEnds<ConeProfile>>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<ConeProfile, &ConeProfile::from>("from", {.bounds = {.least = -1000, .most = 1000}}),
        fields::field_along<ConeProfile, &ConeProfile::to>("to", {.bounds = {.least = -1000, .most = 1000}}),
    });
    static const FieldType type = fields::tuple_type(list);
    return type;
}

template <>
const FieldType& type_of<ConeProfile>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<ConeProfile, &ConeProfile::slope>("slope",
                                                              {.bounds = {.least = -3, .most = 3}, .required = true}),
        fields::field_within<ConeProfile>("ends", &type_of<ProfileEnds<ConeProfile>>),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<StandardProfile>() {
    static const auto list = std::to_array<Field>({
        fields::field<&StandardProfile::name>("name", {.required = true}),
        fields::field<&StandardProfile::inclination>("inclination", {.bounds = {.least = -0.2, .most = 0.2}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ProfileFile>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ProfileFile::name>("name", {.required = true}),
        fields::field<&ProfileFile::text>("text", {.required = true}),
        fields::field<&ProfileFile::unit>("unit", {.bounds = {.least = 1e-06, .most = 1e+06}}),
        fields::field<&ProfileFile::mirror_y>("mirror_y"),
        fields::field<&ProfileFile::mirror_z>("mirror_z"),
        fields::field<&ProfileFile::shift_y>("shift_y", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm"}),
        fields::field<&ProfileFile::shift_z>("shift_z", {.bounds = {.least = -10000, .most = 10000}, .unit = "mm"}),
        fields::field<&ProfileFile::smoothing_length>("smoothing_length",
                                                      {.bounds = {.least = 0, .most = 1000}, .unit = "mm"}),
        fields::field<&ProfileFile::smoothing_order>("smoothing_order", {.bounds = {.least = 2, .most = 3}}),
        fields::field<&ProfileFile::smoothing_lambda>("smoothing_lambda",
                                                      {.bounds = {.least = 0, .most = 1e+09}, .unit = "mm^3"}),
        fields::field<&ProfileFile::kinks>("kinks"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<KinkRule>() {
    static const auto list = std::to_array<Field>({
        fields::field<&KinkRule::angle>("angle", {.bounds = {.least = 0, .most = 3.141592653589793}, .unit = "rad"}),
        fields::field<&KinkRule::rest>("rest", {.bounds = {.least = 0, .most = 3.141592653589793}, .unit = "rad"}),
        fields::field<&KinkRule::width>("width", {.bounds = {.least = 0, .most = 1000}, .unit = "mm"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ProfilePoint>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ProfilePoint::y>("y",
                                        {.bounds = {.least = -10000, .most = 10000}, .unit = "mm", .required = true}),
        fields::field<&ProfilePoint::z>("z",
                                        {.bounds = {.least = -10000, .most = 10000}, .unit = "mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

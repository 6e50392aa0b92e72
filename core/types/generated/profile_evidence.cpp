// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/profile_evidence.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const ProfileEvidence& all) {
    [[maybe_unused]] const auto& [points_given_, points_kept_, spacing_, rounded_to_, cut_off_, largest_distance_,
                                  rms_distance_, kinks_, wheel_, file_, warnings_] = all;
}
[[maybe_unused]] void all_of(const WheelLandmarks& all) {
    [[maybe_unused]] const auto& [tip_, throat_, tread_] = all;
}
[[maybe_unused]] void all_of(const ProfileReading& all) {
    [[maybe_unused]] const auto& [format_, unit_, mirror_y_, mirror_z_, oriented_by_, lines_left_out_] = all;
}

}  // namespace

template <>
const FieldType& type_of<ProfileEvidence>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ProfileEvidence::points_given>("points_given", {.bounds = {.least = 0}, .required = true}),
        fields::field<&ProfileEvidence::points_kept>("points_kept", {.bounds = {.least = 0}, .required = true}),
        fields::field<&ProfileEvidence::spacing>("spacing", {.bounds = {.least = 0}, .unit = "mm", .required = true}),
        fields::field<&ProfileEvidence::rounded_to>("rounded_to",
                                                    {.bounds = {.least = 0}, .unit = "mm", .required = true}),
        fields::field<&ProfileEvidence::cut_off>("cut_off", {.bounds = {.least = 0}, .unit = "mm", .required = true}),
        fields::field<&ProfileEvidence::largest_distance>("largest_distance",
                                                          {.bounds = {.least = 0}, .unit = "mm", .required = true}),
        fields::field<&ProfileEvidence::rms_distance>("rms_distance",
                                                      {.bounds = {.least = 0}, .unit = "mm", .required = true}),
        fields::field<&ProfileEvidence::kinks>("kinks", {.required = true}),
        fields::field<&ProfileEvidence::wheel>("wheel"),
        fields::field<&ProfileEvidence::file>("file"),
        fields::field<&ProfileEvidence::warnings>("warnings", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelLandmarks>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelLandmarks::tip>("tip", {.required = true}),
        fields::field<&WheelLandmarks::throat>("throat", {.required = true}),
        fields::field<&WheelLandmarks::tread>("tread", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ProfileReading>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ProfileReading::format>("format", {.required = true}),
        fields::field<&ProfileReading::unit>("unit", {.bounds = {.least = 0}, .unit = "mm", .required = true}),
        fields::field<&ProfileReading::mirror_y>("mirror_y", {.required = true}),
        fields::field<&ProfileReading::mirror_z>("mirror_z", {.required = true}),
        fields::field<&ProfileReading::oriented_by>("oriented_by", {.required = true}),
        fields::field<&ProfileReading::lines_left_out>("lines_left_out", {.bounds = {.least = 0}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

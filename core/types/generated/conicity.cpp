// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/conicity.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const ContactsRequest& all) {
    [[maybe_unused]] const auto& [shifts_, roll_] = all;
}
[[maybe_unused]] void all_of(const WheelsetContacts& all) {
    [[maybe_unused]] const auto& [shift_, roll_, left_, right_] = all;
}
[[maybe_unused]] void all_of(const RigidContact& all) {
    [[maybe_unused]] const auto& [y_, z_, angle_, radius_, height_, wheel_y_, rail_y_, at_end_] = all;
}
[[maybe_unused]] void all_of(const ProfilesOfSides& all) {
    [[maybe_unused]] const auto& [left_, right_] = all;
}
[[maybe_unused]] void all_of(const PlacedProfiles& all) {
    [[maybe_unused]] const auto& [wheel_, rail_, wheel_origin_, rail_origin_, wheel_evidence_, rail_evidence_] = all;
}

}  // namespace

template <>
const FieldType& type_of<ContactsRequest>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactsRequest::shifts>("shifts", {.required = true}),
        fields::field<&ContactsRequest::roll>("roll"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ConicityRequest>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<ConicityRequest, &ConicityRequest::amplitudes>("amplitudes", {.required = true}),
        fields::field_along<ConicityRequest, &ConicityRequest::settings, &ConicitySettings::roll>("roll"),
        fields::field_along<ConicityRequest, &ConicityRequest::settings, &ConicitySettings::contact_distance>(
            "contact_distance", {.bounds = {.least = 1, .most = 10000}, .unit = "mm"}),
        fields::field_along<ConicityRequest, &ConicityRequest::settings, &ConicitySettings::tolerance>(
            "tolerance", {.bounds = {.least = 0.0001, .most = 1}, .unit = "mm"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<WheelsetContacts>() {
    static const auto list = std::to_array<Field>({
        fields::field<&WheelsetContacts::shift>("shift", {.unit = "mm", .required = true}),
        fields::field<&WheelsetContacts::roll>("roll", {.unit = "rad", .required = true}),
        fields::field<&WheelsetContacts::left>("left", {.required = true}),
        fields::field<&WheelsetContacts::right>("right", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<RigidContact>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RigidContact::y>("y", {.unit = "mm", .required = true}),
        fields::field<&RigidContact::z>("z", {.unit = "mm", .required = true}),
        fields::field<&RigidContact::angle>("angle", {.unit = "rad", .required = true}),
        fields::field<&RigidContact::radius>("radius", {.unit = "mm", .required = true}),
        fields::field<&RigidContact::height>("height", {.unit = "mm", .required = true}),
        fields::field<&RigidContact::wheel_y>("wheel_y", {.unit = "mm", .required = true}),
        fields::field<&RigidContact::rail_y>("rail_y", {.unit = "mm", .required = true}),
        fields::field<&RigidContact::at_end>("at_end", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ProfilesOfSides>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ProfilesOfSides::left>("left", {.required = true}),
        fields::field<&ProfilesOfSides::right>("right", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<PlacedProfiles>() {
    static const auto list = std::to_array<Field>({
        fields::field<&PlacedProfiles::wheel>("wheel", {.required = true}),
        fields::field<&PlacedProfiles::rail>("rail", {.required = true}),
        fields::field<&PlacedProfiles::wheel_origin>("wheel_origin", {.unit = "mm", .required = true}),
        fields::field<&PlacedProfiles::rail_origin>("rail_origin", {.required = true}),
        fields::field<&PlacedProfiles::wheel_evidence>("wheel_evidence", {.required = true}),
        fields::field<&PlacedProfiles::rail_evidence>("rail_evidence", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

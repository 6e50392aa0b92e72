#include "codec_conicity.hpp"

#include <cmath>
#include <limits>

#include "codec_parts.hpp"
#include "codec_profile.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "named_numbers.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr Words<WheelsetRoll, 2> rolls{{{"demanded", WheelsetRoll::demanded}, {"neglected", WheelsetRoll::neglected}}};

// Each of something that may be const.
template <class Part>
auto numbers_of_contact(Part& contact) {
    return named(std::pair("y", &contact.y), std::pair("z", &contact.z), std::pair("angle", &contact.angle),
                 std::pair("radius", &contact.radius), std::pair("height", &contact.height),
                 std::pair("wheel_y", &contact.wheel_y), std::pair("rail_y", &contact.rail_y));
}

json encode_list(const std::vector<double>& numbers, const char* field) {
    json list = json::array();
    for (const double number : numbers) list.push_back(finite(number, field));
    return list;
}

json encode_contact(const RigidContact& contact) {
    json result = encode_numbers(numbers_of_contact(contact));
    result["at_end"] = contact.at_end;
    return result;
}

RigidContact decode_contact(const json& source) {
    RigidContact contact;
    decode_numbers(source, numbers_of_contact(contact));
    contact.at_end = source["at_end"].get<bool>();
    return contact;
}

json encode_placed(const PlacedProfiles& profiles, ArrayWriter& arrays) {
    const auto& [wheel, rail, wheel_origin, rail_origin] = profiles;
    return object({{"wheel", encode_pairs(wheel, arrays)},
                   {"rail", encode_pairs(rail, arrays)},
                   {"wheel_origin", finite(wheel_origin, "wheel_origin")},
                   {"rail_origin", object({{"y", finite(rail_origin.y, "rail_origin.y")},
                                           {"z", finite(rail_origin.z, "rail_origin.z")}})}});
}

PlacedProfiles decode_placed(const json& source, const Frames& frames) {
    const json& rail_origin = source["rail_origin"];
    return {decode_pairs(source["wheel"], frames, "wheel"),
            decode_pairs(source["rail"], frames, "rail"),
            source["wheel_origin"].get<double>(),
            {rail_origin["y"].get<double>(), rail_origin["z"].get<double>()}};
}

}  // namespace

json encode_conicity(const ConicityRequest& wanted) {
    const auto& [roll, contact_distance, tolerance] = wanted.settings;
    return object({{"amplitudes", encode_list(wanted.amplitudes, "conicity.amplitudes")},
                   {"roll", word_for(rolls, roll)},
                   {"contact_distance", finite(contact_distance, "conicity.contact_distance")},
                   {"tolerance", finite(tolerance, "conicity.tolerance")}});
}

ConicityRequest decode_conicity(const json& source) {
    ConicityRequest wanted{source["amplitudes"].get<std::vector<double>>()};
    ConicitySettings& settings = wanted.settings;
    if (source.contains("roll")) settings.roll = meaning_of(source["roll"], rolls);
    settings.contact_distance = source.value("contact_distance", settings.contact_distance);
    settings.tolerance = source.value("tolerance", settings.tolerance);
    return wanted;
}

json encode_conicities(std::span<const EquivalentConicity> conicities) {
    json result = json::array();
    for (const auto& [amplitude, integrated, harmonic, wavelength] : conicities) {
        json entry = object({{"amplitude", finite(amplitude, "An amplitude")}});
        if (std::isfinite(harmonic)) entry["harmonic"] = harmonic;
        if (std::isfinite(integrated)) entry["integrated"] = integrated;
        if (std::isfinite(wavelength)) entry["wavelength"] = wavelength;
        result.push_back(std::move(entry));
    }
    return result;
}

std::vector<EquivalentConicity> decode_conicities(const json& source) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<EquivalentConicity> conicities;
    for (const json& entry : source) {
        const double integrated = entry.value("integrated", none);
        const double missing = integrated == 0 ? std::numeric_limits<double>::infinity() : none;
        conicities.push_back({entry["amplitude"].get<double>(), integrated, entry.value("harmonic", none),
                              entry.value("wavelength", missing)});
    }
    return conicities;
}

json encode_contacts_request(const ContactsRequest& wanted) {
    return object({{"shifts", encode_list(wanted.shifts, "contacts.shifts")}, {"roll", word_for(rolls, wanted.roll)}});
}

ContactsRequest decode_contacts_request(const json& source) {
    ContactsRequest wanted{source["shifts"].get<std::vector<double>>()};
    if (source.contains("roll")) wanted.roll = meaning_of(source["roll"], rolls);
    return wanted;
}

json encode_contacts(std::span<const WheelsetContacts> contacts) {
    json result = json::array();
    for (const WheelsetContacts& one : contacts)
        result.push_back(object({{"shift", finite(one.shift, "A shift")},
                                 {"roll", finite(one.roll, "The roll of a wheelset")},
                                 {"radius_difference", finite(one.radius_difference(), "A radius difference")},
                                 {"left", encode_contact(one.left)},
                                 {"right", encode_contact(one.right)}}));
    return result;
}

std::vector<WheelsetContacts> decode_contacts(const json& source) {
    std::vector<WheelsetContacts> contacts;
    for (const json& one : source)
        contacts.push_back({one["shift"].get<double>(), one["roll"].get<double>(), decode_contact(one["left"]),
                            decode_contact(one["right"])});
    return contacts;
}

json encode_profiles(const ProfilesOfSides& profiles, ArrayWriter& arrays) {
    return object({{"left", encode_placed(profiles.left, arrays)}, {"right", encode_placed(profiles.right, arrays)}});
}

ProfilesOfSides decode_profiles(const json& source, const Frames& frames) {
    return {decode_placed(source["left"], frames), decode_placed(source["right"], frames)};
}

}  // namespace contactd::proto

// Encodes and decodes the results of wheelrail.geometry for a rigid wheelset on rigid rails.
#include <cmath>
#include <limits>

#include "contactd/fields/conicity.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/wheel_rail.hpp"

namespace contactd::proto {

using nlohmann::json;

// Omits numbers that are not finite; the remaining ones show why.
json encode_conicities(std::span<const EquivalentConicity> conicities) {
    json result = json::array();
    for (const auto& [amplitude, integrated, harmonic, wavelength] : conicities) {
        json entry = object({{"amplitude", amplitude}});
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

json encode_contacts(std::span<const WheelsetContacts> contacts) {
    json result = json::array();
    for (const WheelsetContacts& one : contacts) {
        result.push_back(write_answer(one, MemberPath("contacts")));
        result.back()["radius_difference"] = one.radius_difference();
    }
    return result;
}

std::vector<WheelsetContacts> decode_contacts(const json& source) {
    std::vector<WheelsetContacts> contacts;
    for (const json& one : source) read_fields(one, contacts.emplace_back(), MemberPath("contacts"));
    return contacts;
}

json encode_profiles(const ProfilesOfSides& profiles, ArrayWriter& arrays) {
    return write_fields(profiles, MemberPath("profiles"), {&arrays});
}

ProfilesOfSides decode_profiles(const json& source, const Frames& frames) {
    ProfilesOfSides profiles;
    read_fields(source, profiles, MemberPath("profiles"), {frames});
    return profiles;
}

}  // namespace contactd::proto

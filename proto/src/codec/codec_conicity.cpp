#include "codec_conicity.hpp"

#include <cmath>
#include <limits>

#include "codec_parts.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/wheel_rail.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr Words<WheelsetRoll, 2> rolls{{{"demanded", WheelsetRoll::demanded}, {"neglected", WheelsetRoll::neglected}}};

}  // namespace

json encode_conicity(const ConicityRequest& wanted) {
    json amplitudes = json::array();
    for (const double amplitude : wanted.amplitudes) amplitudes.push_back(finite(amplitude, "conicity.amplitudes"));
    const auto& [roll, contact_distance, tolerance] = wanted.settings;
    return object({{"amplitudes", std::move(amplitudes)},
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
        json entry = object(
            {{"amplitude", finite(amplitude, "An amplitude")}, {"harmonic", finite(harmonic, "A harmonic conicity")}});
        if (std::isfinite(integrated)) entry["integrated"] = integrated;
        if (std::isfinite(wavelength)) entry["wavelength"] = wavelength;
        result.push_back(std::move(entry));
    }
    return result;
}

std::vector<EquivalentConicity> decode_conicities(const json& source) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<EquivalentConicity> conicities;
    for (const json& entry : source)
        conicities.push_back({entry["amplitude"].get<double>(), entry.value("integrated", none),
                              entry["harmonic"].get<double>(), entry.value("wavelength", none)});
    return conicities;
}

}  // namespace contactd::proto

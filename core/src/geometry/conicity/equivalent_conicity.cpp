#include "contactd/equivalent_conicity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "contactd/error.hpp"
#include "geometry/conicity/radius_difference.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double room = 1;  // mm: that the middle of the motion may lie beside the middle of the track

void check(std::span<const double> amplitudes, const ConicitySettings& settings) {
    for (std::size_t i = 0; i < amplitudes.size(); ++i)
        if (!(amplitudes[i] >= 0.01 && amplitudes[i] <= 30))
            throw InvalidArgument("amplitudes[" + std::to_string(i) + "]",
                                  "is " + number_text(amplitudes[i]) + "; it must be between 0.01 and 30 mm");
    if (!(settings.contact_distance >= 1 && settings.contact_distance <= 1e4))
        throw InvalidArgument("contact_distance",
                              "is " + number_text(settings.contact_distance) + "; it must be between 1 and 1e4 mm");
    if (!(settings.tolerance >= 1e-6 && settings.tolerance <= 1))
        throw InvalidArgument("tolerance",
                              "is " + number_text(settings.tolerance) + "; it must be between 1e-6 and 1 mm");
}

}  // namespace

std::vector<EquivalentConicity> equivalent_conicities(const WheelsetOnTrack& wheelset,
                                                      std::span<const double> amplitudes,
                                                      const ConicitySettings& settings, const Observer& observer) {
    check(amplitudes, settings);
    if (amplitudes.empty()) return {};
    const double largest = *std::max_element(amplitudes.begin(), amplitudes.end());
    const geometry::RadiusDifference difference(largest + room, settings.tolerance, [&](double shift) {
        observer.throw_if_cancelled();
        const auto contacts = contacts_at(wheelset, shift, settings.roll);
        if (std::abs(shift) <= largest && (contacts.left.at_end || contacts.right.at_end))
            throw InvalidArgument("amplitudes", "reach " + number_text(largest) + " mm, and at the shift " +
                                                    number_text(shift) +
                                                    " mm a profile's end is in contact; take smaller ones, or profiles "
                                                    "that go on");
        return contacts.radius_difference();
    });
    const double inertia = settings.contact_distance * wheelset.nominal_radius;  // 2e r0
    std::vector<EquivalentConicity> conicities;
    for (const double amplitude : amplitudes) {
        const double half = difference.half_swing(amplitude), frequency = std::numbers::pi / half;
        conicities.push_back({.amplitude = amplitude,
                              .integrated = frequency * frequency / 2,
                              .harmonic = difference.harmonic(amplitude),
                              .wavelength = 2 * half * std::sqrt(inertia)});
    }
    return conicities;
}

}  // namespace contactd

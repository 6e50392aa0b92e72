#include "contactd/equivalent_conicity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "contactd/error.hpp"
#include "geometry/conicity/radius_difference.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

// The centre of the motion may lie at these distances (mm) from that of the track.
constexpr double first_room = 1, most_room = 32;

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

void check_rails(const WheelsetOnTrack& wheelset) {
    for (const auto& [side, name] : {std::pair(&wheelset.left, "left"), std::pair(&wheelset.right, "right")})
        if (side->roller_radius)
            throw InvalidArgument(
                std::string(name) + ".track.roller_radius",
                "is " + number_text(*side->roller_radius) +
                    "; the equivalent conicity is defined for a wheelset on rails, not on rollers: remove it");
}

/// Represents a wheelset at the evaluated shifts.
class Shifts {
   public:
    Shifts(const WheelsetOnTrack& wheelset, const ConicitySettings& settings, const Observer& observer)
        : wheelset_(wheelset), settings_(settings), observer_(observer) {}

    double radius_difference(double shift) {
        observer_.throw_if_cancelled();
        const auto contacts = contacts_at(wheelset_, shift, settings_.roll);
        if (contacts.left.at_end || contacts.right.at_end) at_ends_.push_back(shift);
        return contacts.radius_difference();
    }

    void refuse_ends(double centre, double amplitude) const {
        for (const double shift : at_ends_)
            if (std::abs(shift - centre) <= amplitude)
                throw InvalidArgument(
                    "amplitudes",
                    "reach " + number_text(amplitude) + " mm, but at the shift " + number_text(shift) +
                        " mm the end of a profile is in contact; use smaller amplitudes or longer profiles");
    }

   private:
    const WheelsetOnTrack& wheelset_;
    const ConicitySettings& settings_;
    const Observer& observer_;
    std::vector<double> at_ends_;
};

/// Returns the range doubled to a side where a centre may still lie, and unchanged where none may, or where it would be
/// too far.
geometry::Reach wider(const geometry::RadiusDifference& difference, std::span<const double> amplitudes,
                      double largest) {
    geometry::Reach reach = difference.reach();
    for (const double amplitude : amplitudes) {
        const int side = difference.side_of_centre(amplitude);
        double& end = side < 0 ? reach.low : reach.high;
        const double room = 2 * (std::abs(end) - largest);
        if (side == 0 || room > most_room) continue;
        end = side * (largest + room);
        break;
    }
    return reach;
}

/// Returns the difference over the range that all centres need, with both wheels above their rails.
geometry::RadiusDifference difference_around(Shifts& shifts, std::span<const double> amplitudes, double tolerance) {
    const double largest = *std::max_element(amplitudes.begin(), amplitudes.end());
    geometry::RadiusDifference difference({-largest - first_room, largest + first_room}, tolerance,
                                          [&](double shift) { return shifts.radius_difference(shift); });
    while (true) {
        const geometry::Reach reach = wider(difference, amplitudes, largest);
        if (reach == difference.reach()) return difference;
        try {
            difference.extend(reach);
        } catch (const InvalidArgument&) {
            return difference;  // A wheel has left its rail.
        }
    }
}

}  // namespace

std::vector<EquivalentConicity> equivalent_conicities(const WheelsetOnTrack& wheelset,
                                                      std::span<const double> amplitudes,
                                                      const ConicitySettings& settings, const Observer& observer) {
    check(amplitudes, settings);
    check_rails(wheelset);
    if (amplitudes.empty()) return {};
    Shifts shifts(wheelset, settings, observer);
    const auto difference = difference_around(shifts, amplitudes, settings.tolerance);
    const double radius = (wheelset.left.nominal_radius + wheelset.right.nominal_radius) / 2;
    const double inertia = settings.contact_distance * radius;  // 2e r0
    std::vector<EquivalentConicity> conicities;
    for (const double amplitude : amplitudes) {
        observer.throw_if_cancelled();
        const double centre = difference.centre(amplitude);
        shifts.refuse_ends(std::isnan(centre) ? 0 : centre, amplitude);
        const double half = difference.half_swing(amplitude), frequency = std::numbers::pi / half;
        conicities.push_back({.amplitude = amplitude,
                              .integrated = frequency * frequency / 2,
                              .harmonic = difference.harmonic(amplitude),
                              .wavelength = 2 * half * std::sqrt(inertia)});
    }
    return conicities;
}

}  // namespace contactd

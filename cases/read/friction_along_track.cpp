#include "contactd/friction_along_track.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace contactd {
namespace {

enum Law { coulomb = 0, linear = 2, rational = 3, by_temperature = 6 };

constexpr double widest_interval = 3000;    // mm
constexpr double largest_difference = 0.1;  // of coefficients

/// Returns the fraction of a term that remains at a slip velocity.
double share_left(int law, int term, double velocity, double slip_velocity) {
    if (std::isinf(velocity) || !(slip_velocity > 0)) return 0;
    const double v = velocity / slip_velocity;
    if (law == linear) return std::max(0.0, 1 - v / 2);
    if (law == rational) return 1 / (1 + (term == 1 ? v : v * v));
    return std::exp2(-v);
}

/// Returns the friction coefficient at a slip velocity (mm/s), or at a temperature.
double coefficient(int law, const std::vector<double>& f, double at) {
    if (law == coulomb) return f[0];
    if (law == by_temperature) {
        const double share = (at - f[1]) / f[3];
        return f[0] + f[2] * std::clamp(std::isnan(share) ? 0 : share, 0.0, 1.0);
    }
    return f[0] + f[1] * share_left(law, 1, at, f[2]) + f[3] * share_left(law, 2, at, f[4]);
}

/// Returns the slip velocities, or temperatures, where laws can differ most: at rest, at their bends, and far beyond.
std::vector<double> bends_of(int law, const std::vector<double>& f) {
    if (law == coulomb) return {0};
    if (law == by_temperature) return {f[1], f[1] + f[3]};
    return {0, f[2], f[4], std::numeric_limits<double>::infinity()};
}

/// Returns the first set beyond a place, or the end if there is none.
auto behind(const std::vector<ContactFrictionAtPlace>& track, double place) {
    return std::ranges::upper_bound(track, place, {}, &ContactFrictionAtPlace::place);
}

}  // namespace

std::vector<double> friction_along_track(const std::vector<ContactFrictionAtPlace>& track, double place) {
    const auto next = behind(track, place);
    if (next == track.begin()) return next->values;
    const auto last = next - 1;
    std::vector<double> values = last->values;
    if (next == track.end()) return values;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += (next->values[i] - values[i]) / (next->place - last->place) * (place - last->place);
    return values;
}

std::optional<ThinFriction> thin_friction(int law, const std::vector<ContactFrictionAtPlace>& track, double place) {
    const auto next = behind(track, place);
    if (next == track.begin() || next == track.end()) return {};
    const auto last = next - 1;
    if (place == last->place || next->place - last->place <= widest_interval) return {};
    ThinFriction thin{last->place, next->place};
    for (const auto* values : {&last->values, &next->values})
        for (const double at : bends_of(law, *values))
            thin.difference = std::max(
                thin.difference, std::abs(coefficient(law, last->values, at) - coefficient(law, next->values, at)));
    if (thin.difference <= largest_difference) return {};
    return thin;
}

}  // namespace contactd

#include "wheel_rail/thin_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "types/number_text.hpp"
#include "wheel_rail/warnings.hpp"

namespace contactd {
namespace {

using geometry::CandidatePatch;

constexpr double least_sagitta = 0.01;      // mm: error of measured profiles
constexpr double part_of_overlap = 0.2;     // fraction by which curves between points may bend
constexpr double least_of_slices = 0.05;    // mm
constexpr double widest_interval = 0.3;     // rad, between coefficients of friction
constexpr double largest_difference = 0.1;  // of these

/// Holds the distance of two neighbours, and that of the curve between them from the chord (mm).
struct Neighbours {
    double apart = 0, sagitta = 0;
};

/// Returns the widest gap between the points of a profile that has a part of [from, to].
Neighbours widest_gap(const ProfileCurve& profile, double from, double to) {
    const std::vector<double>& s = profile.knots();
    Neighbours widest;
    for (auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(std::ranges::upper_bound(s, from) - s.begin(), 1));
         i < s.size() && s[i - 1] < to; ++i) {
        const double apart = s[i] - s[i - 1];
        if (apart <= widest.apart) continue;
        const double middle = std::abs(profile.curvature(0.5 * (s[i - 1] + s[i])));
        const double ends = std::max(std::abs(profile.curvature(s[i - 1])), std::abs(profile.curvature(s[i])));
        widest = {apart, std::max(middle, 0.5 * ends) * apart * apart / 8};
    }
    return widest;
}

std::optional<std::string> of_points(const ProfileCurve& profile, double from, double to, double overlap,
                                     const std::string& points) {
    if (from > to) std::swap(from, to);
    const Neighbours gap = widest_gap(profile, from, to);
    if (to - from >= 2 * gap.apart || gap.sagitta < std::max(least_sagitta, part_of_overlap * overlap)) return {};
    const double close = std::max((to - from) / 4, gap.apart * std::sqrt(least_sagitta / gap.sagitta));
    return "is " + short_text(to - from) + " mm wide, but " + points + " are " + short_text(gap.apart) +
           " mm apart, and the profile deviates by " + short_text(gap.sagitta) +
           " mm from a straight line between them. Forces depend on the interpolation. Give points at most " +
           short_text(close) + " mm apart.";
}

std::optional<std::string> of_slices(double apart, double curvature, const ContactPlace& place,
                                     const std::string& what) {
    const double length = place.regions.empty() ? 0 : place.regions.front().x.to - place.regions.front().x.from;
    const double sagitta = std::abs(curvature) * apart * apart / 8;
    if (!std::isfinite(apart) || length >= 2 * apart ||
        sagitta < std::max(least_of_slices, std::max(place.penetration, 0.0)))
        return {};
    return "lies between slices that are " + short_text(apart) + " mm apart, and the " + what + " deviates by " +
           short_text(sagitta) + " mm from a straight line between them, more than the overlap of " +
           short_text(place.penetration) +
           " mm. Forces depend on the interpolation. Give slices at shorter distances there.";
}

double distance_of_rail_slices(const WheelRailSetup& setup, double x) {
    const auto& slices = setup.rail_slices;
    const auto next = std::ranges::upper_bound(slices, x, {}, &RailSlice::x);
    return next == slices.begin() || next == slices.end() ? std::numeric_limits<double>::infinity()
                                                          : next->x - (next - 1)->x;
}

double angle_of_wheel_slices(const WheelRailSetup& setup, double angle) {
    constexpr double turn = 2 * std::numbers::pi;
    const auto& slices = setup.wheel_slices;
    const double first = slices.front().angle;
    angle = first + (angle - first) - turn * std::floor((angle - first) / turn);
    const auto next = std::ranges::upper_bound(slices, angle, {}, &WheelSlice::angle);
    return (next == slices.end() ? first + turn : next->angle) - (next - 1)->angle;
}

/// Returns the entries before and behind an angle if these are far apart; otherwise nothing.
template <class Entry>
std::optional<std::pair<Entry, Entry>> far_apart(const std::vector<Entry>& table, double angle) {
    const auto next = std::ranges::upper_bound(table, angle, {}, &Entry::angle);
    if (next == table.begin() || next == table.end() || next->angle - (next - 1)->angle <= widest_interval) return {};
    return std::pair(*(next - 1), *next);
}

std::string lies_between(double angle, const char* what, double one, double other) {
    return "is inclined by " + short_text(angle) + " rad, between " + what + " at " + short_text(one) + " and " +
           short_text(other) + " rad";
}

std::optional<std::string> of_friction(const std::vector<FrictionAtAngle>& mu, double angle) {
    const auto around = far_apart(mu, angle);
    if (!around || std::abs(around->second.mu - around->first.mu) <= largest_difference) return {};
    const auto& [one, other] = *around;
    return "is inclined by " + short_text(angle) + " rad, between friction coefficients of " + short_text(one.mu) +
           " at " + short_text(one.angle) + " and " + short_text(other.mu) + " at " + short_text(other.angle) +
           " rad. Interpolation over such an interval is uncertain. Give friction.mu at more angles.";
}

/// Laws of temperature-dependent friction differ most where one of them bends.
std::optional<std::string> of_heated_friction(const std::vector<TemperatureFrictionAtAngle>& laws, double angle) {
    const auto around = far_apart(laws, angle);
    if (!around) return {};
    const auto& [one, other] = *around;
    double difference = 0, at = 0;
    for (const double T : {one.reference, one.reference + one.range, other.reference, other.reference + other.range}) {
        const double here = std::abs(friction_coefficient(one.law(), 0, T) - friction_coefficient(other.law(), 0, T));
        if (here > difference) at = T;
        difference = std::max(difference, here);
    }
    if (difference <= largest_difference) return {};
    return lies_between(angle, "laws of temperature-dependent friction", one.angle, other.angle) + " that differ by " +
           short_text(difference) + " at " + short_text(at) +
           " degrees Celsius. Interpolation over such an interval is uncertain. Give friction.temperature_by_angle at "
           "more angles.";
}

}  // namespace

std::vector<std::string> thin_data_warnings(const CandidatePatch& found, const WheelRailSetup& setup,
                                            const WheelRailState& state, const geometry::WheelSurface& wheel,
                                            const geometry::RailSurface& rail) {
    const ContactPlace& place = found.place;
    std::vector<std::string> warnings;
    const auto warn = [&](const std::optional<std::string>& sentence) {
        if (sentence) warnings.push_back(name_of(place.reference, setup.side) + " " + *sentence);
    };
    for (const OverlapRegion& region : place.regions) {
        double from = 0.5 * (rail.visible().from + rail.visible().to), to = from;
        if (rail.find_y(region.y.from, from) && rail.find_y(region.y.to, to))
            warn(of_points(rail.profile(), from, to, region.penetration, "points of the rail"));
        const auto on_wheel = [&](double y, double z) {
            return wheel.profile().s_at_y(wheel.frame().inside({region.reference.x, y, z}).y - wheel.base_y());
        };
        warn(of_points(wheel.profile(), on_wheel(region.y.from, region.z.from), on_wheel(region.y.to, region.z.to),
                       region.penetration, "points of the wheel"));
    }
    const double upright = std::abs(std::cos(place.reference.angle));
    if (rail.is_sliced())
        warn(of_slices(distance_of_rail_slices(setup, state.position.x + place.reference.x),
                       1 / (place.radii.rail_along * upright), place, "height of the rail"));
    if (!wheel.is_round()) {
        const double radius = wheel.nominal_radius(), pitch = state.position.pitch + state.wheel.pitch;
        warn(of_slices(radius * angle_of_wheel_slices(setup, -pitch),
                       1 / (place.radii.wheel_along * upright) - 1 / radius, place, "radius of the wheel"));
    }
    if (!setup.friction) return warnings;
    // Rows use friction at their own angles, which range from the first to the last.
    std::vector<double> angles{place.reference.angle};
    if (setup.friction->along_profile && !place.rows.empty())
        angles = {place.rows[place.rows.size() / 2].angle, place.rows.front().angle, place.rows.back().angle};
    const auto warn_once = [&](const auto& sentence_at) {
        for (const double angle : angles)
            if (const auto sentence = sentence_at(angle)) return warn(sentence);
    };
    warn_once([&](double angle) { return of_friction(setup.friction->mu, angle); });
    warn_once([&](double angle) { return of_heated_friction(setup.friction->temperature_by_angle, angle); });
    return warnings;
}

}  // namespace contactd

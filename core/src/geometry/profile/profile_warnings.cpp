#include "geometry/profile/profile_warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/profile/exchanged_profiles.hpp"
#include "geometry/profile/gauge_side.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double narrowest_wheel = 25, narrowest_rail = 12;  // mm: a fifth of usual widths

double width_of(const ProfileCurve& profile) {
    const auto [least, most] = std::ranges::minmax_element(profile.points(), {}, &ProfilePoint::y);
    return most->y - least->y;
}

void warn_of_width(const Profile& profile, const std::string& name, std::vector<std::string>& warnings) {
    const bool wheel = profile.kind == ProfileKind::wheel;
    const double width = width_of(profile.curve);
    if (width >= (wheel ? narrowest_wheel : narrowest_rail)) return;
    warnings.push_back("The profile of the " + name + " is " + short_text(width) + " mm wide, but " +
                       (wheel ? "130" : "70") +
                       " mm are usual. Set unit to 25.4 for points in inches, or to 1000 for metres.");
}

/// Returns the scatter due to measuring errors: the distance (mm) of points from cubics through their neighbours.
double scatter_of(const ProfileCurve& curve) {
    const auto& points = curve.points();
    const auto& s = curve.knots();
    std::vector<double> distances;
    for (std::size_t i = 2; i + 2 < points.size(); ++i) {
        const std::array<std::size_t, 4> others{i - 2, i - 1, i + 1, i + 2};
        double y = -points[i].y, z = -points[i].z, squares = 1;
        for (const std::size_t k : others) {
            double share = 1;
            for (const std::size_t j : others)
                if (j != k) share *= (s[i] - s[j]) / (s[k] - s[j]);
            y += share * points[k].y;
            z += share * points[k].z;
            squares += share * share;
        }
        const double angle = curve.angle(s[i]);
        distances.push_back(std::abs(std::cos(angle) * z - std::sin(angle) * y) / std::sqrt(squares));
    }
    if (distances.empty()) return 0;
    const auto median = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::ranges::nth_element(distances, median);
    return *median / 0.6745;  // for normally distributed errors
}

constexpr std::size_t measured = 100;  // points: profiles with fewer are not measured
constexpr double much = 2e-3;          // 1/mm: error of curvature for treads and heads with radii of 300 mm

/// Second differences of rounded points have the size of a step over the square of their distance.
bool warn_of_rounding(const Profile& profile, const std::string& name, std::vector<std::string>& warnings) {
    const double step = profile.evidence.rounded_to, apart = profile.evidence.spacing;
    if (step == 0 || step < much * apart * apart) return false;
    warnings.push_back("The points of the " + name + " are rounded to " + short_text(step) + " and " +
                       short_text(apart) +
                       " mm apart, so rounding dominates their curvature and the pressures. Smooth them with a "
                       "smoothing_length of about 5 mm.");
    return true;
}

/// Errors of this size cause second differences of sqrt(6) times the error over the square of the distance. Smoothing
/// over L leaves a curvature of 29 errors sqrt(distance / L^5), by the spectrum of both.
void warn_of_scatter(const Profile& profile, const std::string& name, std::vector<std::string>& warnings) {
    const double scatter = scatter_of(profile.curve), apart = profile.evidence.spacing;
    if (2.45 * scatter < 2 * much * apart * apart) return;
    const double length = std::pow(29 * scatter * std::sqrt(apart) / much, 0.4);
    warnings.push_back("The points of the " + name + " scatter by about " + short_text(1e3 * scatter) +
                       " um where they are " + short_text(apart) +
                       " mm apart, so noise dominates their curvature and the pressures. Smooth them with a "
                       "smoothing_length of about " +
                       short_text(std::clamp(std::ceil(length), 2.0, 10.0)) + " mm.");
}

void warn_of_exchange(const Profile& profile, const std::string& name, std::vector<std::string>& warnings) {
    const bool wheel = profile.kind == ProfileKind::wheel;
    if (!(wheel ? has_shape_of_rail(profile.curve) : has_shape_of_wheel(profile.curve))) return;
    warnings.push_back("The profile of the " + name + " has the shape of " +
                       (wheel ? "the head of a rail" : "a wheel with its flange upwards") +
                       ". Check whether the profiles of wheel and rail are exchanged.");
}

/// A profile that is smoothed by more than measuring errors has lost a part of its shape.
void warn_of_smoothing(const Profile& profile, const std::string& name, std::vector<std::string>& warnings) {
    constexpr double far = 0.3;  // mm
    const double moved = profile.evidence.largest_distance;
    if (!(moved > far)) return;
    warnings.push_back("Smoothing has moved points of the " + name + " by up to " + short_text(moved) +
                       " mm: smoothing_length " + short_text(profile.evidence.cut_off) +
                       " mm removes its arcs as well as the noise. About 5 mm suits measured profiles.");
}

}  // namespace

std::vector<std::string> profile_warnings(const Profile& profile) {
    const std::string name(name_of(profile.kind));
    std::vector<std::string> warnings;
    warn_of_width(profile, name, warnings);
    warn_of_exchange(profile, name, warnings);
    const bool is_measured = profile.evidence.points_given >= measured;
    if (profile.evidence.cut_off == 0 && is_measured && !warn_of_rounding(profile, name, warnings))
        warn_of_scatter(profile, name, warnings);
    warn_of_smoothing(profile, name, warnings);
    if (profile.kind == ProfileKind::rail && has_gauge_side_at_right(profile.curve))
        warnings.push_back(gauge_side_warning("rail"));
    return warnings;
}

std::string gauge_side_warning(const std::string& name) {
    return "The " + name +
           " appears to have its gauge side at y > 0: it leans to that side, or was measured down to the gauge on that "
           "side only. The gauge side must lie at y < 0, also for a left rail. Change mirror_y.";
}

std::string bridge_warning(ProfileKind kind, const ProfilePoint& from, const ProfilePoint& to) {
    const auto text = [](const ProfilePoint& point) {
        return "(" + short_text(point.y) + ", " + short_text(point.z) + ")";
    };
    return "Between " + text(from) + " and " + text(to) + " the " + std::string(name_of(kind)) +
           " is hidden from above, behind a lip. Its outline is taken as vertical there, and no contact is found "
           "behind the lip.";
}

}  // namespace contactd::geometry

#include "wheel_rail/plausibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double narrowest_wheel = 25, narrowest_rail = 12;  // mm: a fifth of what is usual
constexpr double least_flange = 15;                          // mm below the tape circle: what has less has no flange
constexpr double near_tip = 3;                               // mm
constexpr double near_back = 15;                             // mm beyond the profile's end
constexpr double steepest_head = 1.4;                        // rad: the side of a rail's head

// --- profiles --------------------------------------------------------------------------------------------------------

double width_of(const ProfileCurve& profile) {
    const auto [least, most] = std::ranges::minmax_element(profile.points(), {}, &ProfilePoint::y);
    return most->y - least->y;
}

void warn_of_width(const ProfileSpec& spec, const ProfileCurve& curve, const char* name, double narrowest,
                   const char* usual, std::vector<std::string>& warnings) {
    const auto* points = std::get_if<ProfilePoints>(&spec.shape);
    const double width = width_of(curve);
    if (points == nullptr || width >= narrowest) return;
    warnings.push_back("The profile of the " + std::string(name) + " is " + short_text(width) + " mm wide, where " +
                       usual + " mm are usual. Points in inches need unit 25.4, in metres unit 1000.");
}

/// The coarsest step that all coordinates are multiples of, if there is one.
std::optional<double> rounding_of(const std::vector<ProfilePoint>& points) {
    for (const double step : {1.0, 0.1, 0.01, 0.001}) {
        const auto is_rounded = [step](double value) {
            return std::abs(value / step - std::round(value / step)) < 1e-6;
        };
        if (std::ranges::all_of(points, [&](const ProfilePoint& p) { return is_rounded(p.y) && is_rounded(p.z); }))
            return step;
    }
    return std::nullopt;
}

/// Second differences of rounded points are a step over the square of their distance.
void warn_of_rounding(const ProfileSpec& spec, const ProfileCurve& curve, const char* name,
                      std::vector<std::string>& warnings) {
    constexpr std::size_t measured = 100;  // points: fewer are drawn by hand
    constexpr double much = 2e-3;          // 1/mm, of treads and heads whose radii are 300 mm
    const auto* points = std::get_if<ProfilePoints>(&spec.shape);
    if (points == nullptr || points->smoothing_length > 0 || points->points.size() < measured) return;
    const std::optional<double> step = rounding_of(points->points);
    const double apart = (curve.end() - curve.begin()) / static_cast<double>(curve.points().size() - 1);
    if (!step || *step * points->unit < much * apart * apart) return;
    warnings.push_back("The points of the " + std::string(name) + " are rounded to " + short_text(*step) + " and " +
                       short_text(apart) +
                       " mm apart, so that their curvature is mostly rounding, and pressures with it. Smooth them: "
                       "smoothing_length, about 5 mm.");
}

/// A profile that is smoothed by more than measurements err has lost a part of its shape.
void warn_of_smoothing(const ProfileSpec& spec, double moved, const char* name, std::vector<std::string>& warnings) {
    constexpr double much = 0.3;  // mm
    if (!(moved > much)) return;
    warnings.push_back("Smoothing has moved points of the " + std::string(name) + " by up to " + short_text(moved) +
                       " mm: smoothing_length " + short_text(std::get<ProfilePoints>(spec.shape).smoothing_length) +
                       " mm takes away its arcs, not only the noise. About 5 mm suits measured profiles.");
}

// --- where they touch ------------------------------------------------------------------------------------------------

/// The lowest point of a wheel's profile, where it is that of a flange.
std::optional<ProfilePoint> flange_tip(const ProfileCurve& wheel) {
    const ProfilePoint lowest = *std::ranges::max_element(wheel.points(), {}, &ProfilePoint::z);
    return lowest.z > least_flange && lowest.y < 0 ? std::optional(lowest) : std::nullopt;
}

void warn_of_flange_back(const WheelRailSetup& setup, const ProfileCurve& wheel, std::vector<std::string>& warnings) {
    const std::optional<ProfilePoint> tip = flange_tip(wheel);
    const double back = setup.wheelset.flange_back_position;
    const double end = std::ranges::min_element(wheel.points(), {}, &ProfilePoint::y)->y;
    if (!tip || (back <= tip->y && back >= end - near_back)) return;
    warnings.push_back("wheelset.flange_back_position is " + short_text(back) +
                       " mm, and the wheel's profile has the tip of its flange at y = " + short_text(tip->y) +
                       " and begins at " + short_text(end) +
                       ": the back of the flange lies between them, or the profile's origin is elsewhere.");
}

std::string name_of(const ContactReference& reference, Side side) {
    return "The contact at y = " + short_text(side == Side::left ? -reference.y : reference.y) + " mm";
}

}  // namespace

std::vector<std::string> plausibility_warnings(const WheelRailSetup& setup, const geometry::Profiles& profiles) {
    std::vector<std::string> warnings;
    if (setup.wheel_slices.empty()) {
        warn_of_width(setup.wheel, profiles.wheel, "wheel", narrowest_wheel, "130", warnings);
        warn_of_rounding(setup.wheel, profiles.wheel, "wheel", warnings);
        warn_of_smoothing(setup.wheel, profiles.wheel_smoothed, "wheel", warnings);
        warn_of_flange_back(setup, profiles.wheel, warnings);
    }
    if (setup.rail_slices.empty()) {
        warn_of_width(setup.rail, profiles.rail, "rail", narrowest_rail, "70", warnings);
        warn_of_rounding(setup.rail, profiles.rail, "rail", warnings);
        warn_of_smoothing(setup.rail, profiles.rail_smoothed, "rail", warnings);
    }
    return warnings;
}

std::vector<std::string> plausibility_warnings(const ContactReference& reference, Side side,
                                               const geometry::WheelSurface& wheel, const geometry::RailSurface& rail) {
    std::vector<std::string> warnings;
    const double y = wheel.frame().inside({reference.x, reference.y, reference.z}).y - wheel.base_y();
    if (const auto tip = flange_tip(wheel.profile()); tip && y < tip->y + near_tip)
        warnings.push_back(name_of(reference, side) +
                           " lies at the tip or the back of the wheel's flange, which runs on no rail: check the "
                           "wheel's orientation (mirror_y, mirror_z), flange_back_position, the gauge and position.y.");
    const auto normal = rail.frame().axes.turned_back({0, std::cos(reference.angle), std::sin(reference.angle)});
    const double turned = std::atan2(normal.z, normal.y);
    if (std::abs(turned) > steepest_head)
        warnings.push_back(name_of(reference, side) + " lies beside the rail's head, where its surface leans by " +
                           short_text(std::abs(turned)) +
                           " rad: check the rail's orientation and position, the gauge and position.y.");
    return warnings;
}

}  // namespace contactd

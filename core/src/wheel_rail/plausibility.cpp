#include "wheel_rail/plausibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "types/number_text.hpp"
#include "wheel_rail/warnings.hpp"

namespace contactd {
namespace {

constexpr double least_flange = 15;    // mm below the tape circle: wheels with less have no flange
constexpr double near_tip = 3;         // mm
constexpr double near_back = 15;       // mm beyond the profile's end
constexpr double steepest_head = 1.4;  // rad: inclination of the side of a rail's head

/// Returns the lowest point of a wheel's profile if it is that of a flange.
std::optional<ProfilePoint> flange_tip(const ProfileCurve& wheel) {
    const ProfilePoint lowest = *std::ranges::max_element(wheel.points(), {}, &ProfilePoint::z);
    return lowest.z > least_flange && lowest.y < 0 ? std::optional(lowest) : std::nullopt;
}

void warn_of_flange_back(const WheelRailSetup& setup, const ProfileCurve& wheel, std::vector<std::string>& warnings) {
    const std::optional<ProfilePoint> tip = flange_tip(wheel);
    const double back = setup.wheelset.flange_back_position;
    const double end = std::ranges::min_element(wheel.points(), {}, &ProfilePoint::y)->y;
    if (!tip || (back <= tip->y && back >= end - near_back)) return;
    warnings.push_back(
        "wheelset.flange_back_position is " + short_text(back) + " mm, but the wheel's profile begins at y = " +
        short_text(end) + " and has the tip of its flange at " + short_text(tip->y) +
        ". The back of the flange must lie between them; check flange_back_position and the origin of the profile.");
}

}  // namespace

std::vector<std::string> plausibility_warnings(const WheelRailSetup& setup, const geometry::Profiles& profiles) {
    std::vector<std::string> warnings;
    if (setup.wheel_slices.empty()) {
        warnings = profiles.wheel_warnings;
        warn_of_flange_back(setup, profiles.wheel, warnings);
    }
    warnings.insert(warnings.end(), profiles.rail_warnings.begin(), profiles.rail_warnings.end());
    return warnings;
}

std::vector<std::string> plausibility_warnings(const ContactReference& reference, Side side,
                                               const geometry::WheelSurface& wheel, const geometry::RailSurface& rail) {
    std::vector<std::string> warnings;
    const double y = wheel.frame().inside({reference.x, reference.y, reference.z}).y - wheel.base_y();
    if (const auto tip = flange_tip(wheel.profile()); tip && y < tip->y + near_tip)
        warnings.push_back(
            name_of(reference, side) +
            " lies at the tip or the back of the wheel's flange, which normally does not touch a rail. Check the "
            "wheel's orientation (mirror_y, mirror_z), flange_back_position, the gauge and position.y.");
    const auto normal = rail.frame().axes.rotated_back({0, std::cos(reference.angle), std::sin(reference.angle)});
    const double rotated = std::atan2(normal.z, normal.y);
    if (std::abs(rotated) > steepest_head)
        warnings.push_back(name_of(reference, side) +
                           " lies beside the rail's head, where its surface is inclined by " +
                           short_text(std::abs(rotated)) +
                           " rad. Check the rail's orientation and position, the gauge and position.y.");
    return warnings;
}

}  // namespace contactd

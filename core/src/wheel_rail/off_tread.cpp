#include "wheel_rail/off_tread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "types/number_text.hpp"

namespace contactd {
namespace {

using geometry::RailSurface;
using geometry::WheelSurface;

constexpr double beyond_throat = 10;  // mm: distance at which flanges have become treads
constexpr double least_lift = 1;      // mm: contacts in the throat lift treads by tenths
constexpr double lift_of_face = 0.2;  // mm: least lift where Fy exceeds Fz, as on the steep face
constexpr double near_end = 0.15;     // in widths: treads are rolled up to 25 mm from their ends

double y_on_wheel(const ContactReference& reference, const WheelSurface& wheel) {
    return wheel.frame().inside({reference.x, reference.y, reference.z}).y - wheel.base_y();
}

/// Returns how much the wheel can be lowered until its profile beyond y touches (mm), which is not finite if no rail is
/// below it.
double lift(double y, const WheelSurface& wheel, const RailSurface& rail) {
    constexpr double step = 0.5;  // mm
    const ProfileCurve& profile = wheel.profile();
    double least = std::numeric_limits<double>::infinity();
    double rail_s = 0.5 * (rail.visible().from + rail.visible().to);
    for (double s = std::max(profile.s_at_y(y), wheel.visible().from); s <= wheel.visible().to; s += step) {
        const geometry::Vector3 at = wheel.frame().outside(wheel.in_wheel(0, s));
        if (!rail.find_y(at.y, rail_s)) continue;
        const double gap = rail.height(at.x, at.y, rail_s) - at.z;
        if (gap < least) least = gap;
    }
    return least;
}

double lateral_over_vertical(const WheelRailSolution& solution) {
    return std::abs(solution.forces.track.Fy / solution.forces.track.Fz);
}

}  // namespace

std::optional<std::string> off_tread_warning(const WheelRailSolution& solution, const geometry::Profiles& profiles,
                                             const WheelSurface& wheel, const RailSurface& rail) {
    if (solution.patches.empty() || !(solution.forces.track.Fz > 0)) return std::nullopt;
    double innermost = std::numeric_limits<double>::infinity(), outermost = -innermost;
    for (const WheelRailPatch& patch : solution.patches) {
        const double y = y_on_wheel(patch.place.reference, wheel);
        innermost = std::min(innermost, y);
        outermost = std::max(outermost, y);
    }
    if (profiles.landmarks) {
        const double tread = profiles.landmarks->throat.y + beyond_throat;
        const double lifted = outermost < tread ? lift(tread, wheel, rail) : 0;
        const double ratio = lateral_over_vertical(solution);
        if (lifted > least_lift || (lifted > lift_of_face && ratio > 1))
            return "The wheel climbs on its flange: Fy/Fz = " + short_text(ratio) +
                   (std::isfinite(lifted) ? ", and its tread is " + short_text(lifted) + " mm above its contact."
                                          : ", and no rail is below its tread.") +
                   " Forces and pressures are those of a wheel held in this position; check position.y, roll and the "
                   "gauge.";
    }
    const auto& points = wheel.profile().points();
    const double end = points.back().y, width = end - points.front().y;
    if (innermost < end - near_end * width) return std::nullopt;
    const double s = wheel.profile().s_at_y(std::min(innermost, end));
    const double tread = profiles.landmarks ? profiles.landmarks->tread.z : 0;
    return "The wheel rolls on the end of its tread, " + short_text(end - innermost) +
           " mm from where its profile ends: Fy/Fz = " + short_text(lateral_over_vertical(solution)) +
           ", and the contact is " + short_text(tread - wheel.profile().at(s).z) +
           " mm above that of the running circle. Check position.y and the gauge.";
}

}  // namespace contactd

#include "contactd/wheelset_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "contactd/error.hpp"
#include "geometry/conicity/bracketed_root.hpp"
#include "geometry/conicity/least_gap.hpp"
#include "geometry/placement/gauge_point.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using geometry::LeastGap;

constexpr double largest_roll = 0.2, precise_roll = 1e-13;  // rad

LeastGap gap_of(const WheelOverRail& pair, double shift, double roll, double outwards) {
    const LeastGap found = geometry::least_gap(pair, outwards * shift, outwards * roll);
    if (std::isinf(found.gap))
        throw InvalidArgument(
            "shift", "is " + number_text(shift) + ", where the " + (outwards > 0 ? "right" : "left") +
                         " wheel is not above its rail; check gauge and flange_back_distance, or use a smaller shift");
    return found;
}

RigidContact contact_of(const WheelOverRail& pair, const LeastGap& found, double outwards) {
    const ProfilePoint along = pair.rail.slope(found.rail_s);
    return {.y = outwards * found.place.y,
            .z = found.place.z,
            .angle = outwards * std::atan2(along.z, along.y),
            .radius = pair.nominal_radius + pair.wheel.at(found.wheel_s).z,
            .height = found.gap,
            .wheel_y = pair.wheel.at(found.wheel_s).y,
            .rail_y = pair.rail.at(found.rail_s).y,
            .at_end = found.at_end};
}

/// Returns the rail rotated by the track's cant.
ProfileCurve canted(const ProfileCurve& rail, double cant) {
    if (cant == 0) return rail;
    std::vector<ProfilePoint> points;
    for (const ProfilePoint& point : rail.points()) points.push_back(geometry::canted(point, cant));
    return ProfileCurve(std::move(points), rail.kinks());
}

}  // namespace

WheelOverRail wheel_over_rail(const ProfileCurve& wheel, const ProfileCurve& rail, const Track& track,
                              const Wheelset& wheelset) {
    WheelRailSetup setup;
    setup.track = track;
    setup.wheelset = wheelset;
    validate(setup);
    const double width = rail.points().back().y - rail.points().front().y;
    if (!track.rail_origin && !(track.gauge > width))
        throw InvalidArgument("track.gauge", "is " + number_text(track.gauge) + ", less than the width of a rail, " +
                                                 short_text(width) + " mm: the rails would overlap");
    return {wheel,
            canted(rail, track.cant),
            wheelset.flange_back_distance / 2 - wheelset.flange_back_position,
            geometry::rail_origin(rail, track),
            wheelset.nominal_radius,
            track.roller_radius};
}

WheelsetOnTrack wheelset_on_track(const ProfileCurve& wheel, const ProfileCurve& rail, const Track& track,
                                  const Wheelset& wheelset) {
    const WheelOverRail pair = wheel_over_rail(wheel, rail, track, wheelset);
    return {pair, pair};
}

WheelsetContacts contacts_at(const WheelsetOnTrack& wheelset, double shift, WheelsetRoll roll) {
    if (!std::isfinite(shift))
        throw InvalidArgument("shift", "is " + number_text(shift) + "; it must be finite, in mm");
    const auto right = [&](double rotated) { return gap_of(wheelset.right, shift, rotated, 1); };
    const auto left = [&](double rotated) { return gap_of(wheelset.left, shift, rotated, -1); };
    double rotated = 0;
    if (roll == WheelsetRoll::demanded) {
        // A roll to the right lowers the right wheel, and the gap on the left widens. Both wheels share one axle, so
        // heights are those of its middle.
        const double larger = wheelset.left.nominal_radius - wheelset.right.nominal_radius;
        const auto imbalance = [&](double angle) { return left(angle).gap - right(angle).gap - larger; };
        double low = 0, high = 0, at_low = imbalance(0), at_high = at_low;
        const double usual = std::abs(at_low) / wheelset.right.wheel_origin;  // about twice the required range
        for (double reach = std::max(1e-7, usual); at_low > 0 || at_high < 0; reach *= 2) {
            if (!(reach <= largest_roll))
                throw InvalidArgument("shift",
                                      "is " + number_text(shift) +
                                          ", but at no roll below 0.2 rad are both wheels in contact with their rails");
            if (at_low > 0)
                high = low, at_high = at_low, at_low = imbalance(low = -reach);
            else
                low = high, at_low = at_high, at_high = imbalance(high = reach);
        }
        rotated = geometry::bracketed_root(low, high, at_low, at_high, precise_roll, imbalance);
    }
    return {.shift = shift,
            .roll = rotated,
            .left = contact_of(wheelset.left, left(rotated), -1),
            .right = contact_of(wheelset.right, right(rotated), 1)};
}

}  // namespace contactd

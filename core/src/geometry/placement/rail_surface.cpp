#include "geometry/placement/rail_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contactd/error.hpp"
#include "geometry/placement/ascending_root.hpp"
#include "geometry/placement/gauge_point.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

ProfilePoint rotated(const ProfilePoint& point, double cosine, double sine) {
    return {cosine * point.y - sine * point.z, sine * point.y + cosine * point.z};
}

/// Refuses a profile whose field side extends down to the gauge height while its gauge side ends far above it, because
/// its sides are probably exchanged.
void check_gauge_side(const ProfileCurve& profile, double at_top, const Track& track) {
    const double top = canted(profile.at(at_top), track.cant).z;
    double gauge_side = 0, field_side = 0;
    for (std::size_t i = 0; i < profile.points().size(); ++i) {
        double& lowest = profile.knots()[i] < at_top ? gauge_side : field_side;
        lowest = std::max(lowest, canted(profile.points()[i], track.cant).z - top);
    }
    if (gauge_side < 0.5 * track.gauge_height && field_side >= track.gauge_height)
        throw InvalidArgument(
            "track.gauge_height",
            "is " + number_text(track.gauge_height) + ", but the rail's profile ends " + short_text(gauge_side) +
                " mm below its top at y < 0, the gauge side, and reaches " + short_text(field_side) +
                " mm at y > 0: change mirror_y if the gauge face is at y > 0, or give track.rail_origin");
}

}  // namespace

ProfilePoint rail_origin(const ProfileCurve& profile, const Track& track) {
    if (track.rail_origin) return *track.rail_origin;
    const double at_top = s_of_top(profile, track.cant);
    const ProfilePoint top = canted(profile.at(at_top), track.cant);
    check_gauge_side(profile, at_top, track);
    const auto at_gauge = s_of_depth(profile, track.cant, at_top, top.z + track.gauge_height);
    const double gauge_y = least_y(profile, track.cant, at_gauge.value_or(profile.begin()), at_top);
    return {track.gauge / 2 - gauge_y, track.roller_radius ? 0 : -top.z};
}

RailSurface::RailSurface(ProfileCurve profile, const Track& track, ProfilePoint origin, const RailDeviation& deviation)
    : profile_(std::move(profile)), radius_(track.roller_radius) {
    const double angle = deviation.roll - track.cant;
    frame_ = {{0, origin.y + deviation.y, origin.z + deviation.z}, Rotation::roll(angle)};
    cosine_ = std::cos(angle);
    sine_ = std::sin(angle);
    if (radius_) {
        axle_ = frame_.origin.z + *radius_;
        from_inwards_axle_ = *axle_;
        if (track.roller_leans) {
            axle_ = origin.z + *radius_;
            inwards_ = {-sine_, cosine_};
            from_inwards_axle_ = inwards_.y * frame_.origin.y + inwards_.z * frame_.origin.z + *radius_;
        }
    }
    visible_ = visible_part(profile_);
}

RailSurface::RailSurface(std::shared_ptr<const SlicedRail> slices, double x, const Track& track, ProfilePoint origin,
                         const RailDeviation& deviation)
    : RailSurface(slices->at(x), track, origin, deviation) {
    slices_ = std::move(slices);
    x_ = x;
}

Span RailSurface::visible_part(const ProfileCurve& profile) const {
    return visible_span(
        profile, [this](const ProfilePoint& point) { return frame_.origin.y + rotated(point, cosine_, sine_).y; });
}

ProfileCurve::Place RailSurface::placed(const ProfileCurve& profile, double s) const {
    ProfileCurve::Place place = profile.place(s);
    for (ProfilePoint* part : {&place.at, &place.slope, &place.curving}) *part = rotated(*part, cosine_, sine_);
    place.at.y += frame_.origin.y;
    place.at.z += frame_.origin.z;
    return place;
}

ProfilePoint RailSurface::placed(const ProfilePoint& point) const {
    const ProfilePoint at = rotated(point, cosine_, sine_);
    return {at.y + frame_.origin.y, at.z + frame_.origin.z};
}

bool RailSurface::find_y(double y, double& s) const {
    return find_ascending(
        [this](double at) {
            const auto here = place(at);
            return Sloped{here.at.y, here.slope.y};
        },
        y, visible_.from, visible_.to, s);
}

// Points of a leaning roller move slightly across as they rotate, so the point at y at x was slightly beside it.
double RailSurface::height(double x, double y, double s) const {
    find_y(y, s);
    if (!leans()) return z_at(x, y, place(s).at.z);
    constexpr int enough = 4;
    for (int pass = 0; pass < enough; ++pass) find_y(y - inwards_.y * sag(x, place(s).at), s);
    return rotated_to(x, place(s)).at.z;
}

// Between columns the surface is a cubic through the four around, because slices are farther apart. If one of the outer
// columns has no rail there, because a part of it begins or ends, it is extrapolated linearly.
double RailSurface::z_at(double x, double y, double z) const {
    if (!slices_) return axle_ ? z + sag(x, {y, z}) : z;
    const double position = x / step_along;
    const double first = std::floor(position) - 1, t = position - first;  // from 1 to 2
    const auto column = [&](int k) { return column_z(static_cast<int>(first) + k, y); };
    const double before = column(1), behind = column(2);
    double left = column(0), right = column(3);
    if (std::isnan(left)) left = 2 * before - behind;
    if (std::isnan(right)) right = 2 * behind - before;
    return -(t - 1) * (t - 2) * (t - 3) / 6 * left + t * (t - 2) * (t - 3) / 2 * before -
           t * (t - 1) * (t - 3) / 2 * behind + t * (t - 1) * (t - 2) / 6 * right;
}

double RailSurface::slope_along(double x, double y, double z) const {
    if (slices_) {
        constexpr double step = 0.25 * step_along;
        return (z_at(x + step, y, z) - z_at(x - step, y, z)) / (2 * step);
    }
    if (!axle_) return 0;
    if (leans()) {
        constexpr double step = 0.1;
        const double middle = 0.5 * (visible_.from + visible_.to);
        return (height(x + step, y, middle) - height(x - step, y, middle)) / (2 * step);
    }
    const double radius = *axle_ - z;
    return x / std::sqrt(std::max(radius * radius - x * x, 1e-12));
}

double RailSurface::curvature_along(double x, double y, double s) const {
    if (!slices_) return curvature_along();
    const double bulge = height(x + step_along, y, s) + height(x - step_along, y, s) - 2 * height(x, y, s);
    // It is straight if a part of the rail begins or ends within a column.
    return std::isnan(bulge) ? 0 : bulge / (step_along * step_along);
}

double RailSurface::column_z(int column, double y) const {
    auto found = columns_.find(column);
    if (found == columns_.end()) {
        const ProfileCurve profile = section(column * step_along);
        const Span visible = visible_part(profile);
        found = columns_.emplace(column, Column{profile, visible, 0.5 * (visible.from + visible.to)}).first;
    }
    Column& at = found->second;
    const auto look = [&](double s) {
        const auto here = placed(at.profile, s);
        return Sloped{here.at.y, here.slope.y};
    };
    double s = at.s;
    if (!find_ascending(look, y, at.visible.from, at.visible.to, s)) return std::numeric_limits<double>::quiet_NaN();
    at.s = s;
    return placed(at.profile, s).at.z;
}

ProfileCurve::Place RailSurface::rotated_to(double x, ProfileCurve::Place place) const {
    if (!axle_) return place;
    const double radius = radius_at(place.at);
    const double sunk = sag(x, place.at);
    const double more = (radius / std::sqrt(std::max(radius * radius - x * x, 1e-12)) - 1) *
                        (inwards_.y * place.slope.y + inwards_.z * place.slope.z);
    place.at.y += inwards_.y * sunk;
    place.at.z += inwards_.z * sunk;
    place.slope.y += inwards_.y * more;
    place.slope.z += inwards_.z * more;
    return place;
}

/// Returns by how much a point that rotates about the axle approaches it along x = 0.
double RailSurface::sag(double x, const ProfilePoint& at) const {
    const double radius = radius_at(at);
    const double square = radius * radius - x * x;
    return square > 0 ? radius - std::sqrt(square) : radius;
}

}  // namespace contactd::geometry

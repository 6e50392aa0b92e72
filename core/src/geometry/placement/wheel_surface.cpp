#include "geometry/placement/wheel_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace contactd::geometry {
namespace {

/// Returns the frame in which a profile has the position that it has in the frame of a rigid wheelset.
Frame deviating(const Frame& wheelset, const Vector3& profile_origin, const WheelDeviation& by) {
    const Vector3 moved{by.x, by.y, by.z};
    if (by.roll == 0 && by.yaw == 0) return {wheelset.origin + wheelset.axes * moved, wheelset.axes};
    const Rotation axes = wheelset.axes * Rotation::yaw_then_roll(by.yaw, by.roll);
    return {wheelset.outside(profile_origin + moved) - axes * profile_origin, axes};
}

}  // namespace

WheelSurface::WheelSurface(ProfileCurve profile, const Wheelset& wheelset, const WheelsetPosition& position,
                           const WheelDeviation& deviation, std::shared_ptr<const OutOfRound> out_of_round)
    : profile_(std::move(profile)),
      base_y_(wheelset.flange_back_distance / 2 - wheelset.flange_back_position),
      radius_(wheelset.nominal_radius),
      pitch_(position.pitch + deviation.pitch),
      wheelset_{{0, position.y, position.height() - wheelset.nominal_radius},
                Rotation::yaw_then_roll(position.yaw, position.roll)},
      frame_(deviating(wheelset_, {0, base_y_, radius_}, deviation)),
      out_of_round_(std::move(out_of_round)) {
    const double cosine = frame_.axes.y.y, sine = -frame_.axes.z.y;  // axes of the profile's plane, seen along x
    visible_ = visible_span(profile_, [&](const ProfilePoint& point) {
        return frame_.origin.y + cosine * (base_y_ + point.y) - sine * (radius_ + point.z);
    });
}

WheelSurface WheelSurface::lowered(double dz) const {
    WheelSurface wheel = *this;
    wheel.wheelset_.origin.z += dz;
    wheel.frame_.origin.z += dz;
    return wheel;
}

// With r the radius at the angle of the point, z^2 + x^2 = r^2 is solved by Newton's method in z.
BelowAxle WheelSurface::below_axle(double x, const ProfileCurve::Place& here, double s) const {
    constexpr double settled = 1e-11;  // mm
    const double rho = radius_ + here.at.z;
    double z = std::sqrt(std::max(rho * rho - x * x, 1e-12));
    if (!out_of_round_) return {z, -x, rho * here.slope.z, z};
    OutOfRound::Place beside;
    double r = rho;
    for (int iteration = 0; iteration < 30; ++iteration) {
        beside = out_of_round_->at(std::atan2(x, z) - pitch_, s);
        r = rho + beside.radius;
        const double step = 0.5 * (z * z + x * x - r * r) / (z + r * beside.by_angle * x / (x * x + z * z));
        z = std::max(z - step, 1e-6);
        if (!(std::abs(step) > settled)) break;
    }
    return {z, beside.by_angle * z / r - x, r * (here.slope.z + beside.by_s), z + beside.by_angle * x / r};
}

double WheelSurface::radius_along(double x, double s) const {
    constexpr double step = 5;  // mm: a few slices, between which curvatures are no more accurate than radii
    const ProfileCurve::Place here = profile_.place(s);
    if (!out_of_round_) return radius_ + here.at.z;
    const auto z = [&](double at) { return below_axle(at, here, s).z; };
    const double before = z(x - step), behind = z(x + step), incline = (behind - before) / (2 * step);
    const double bulge = (2 * z(x) - before - behind) / (step * step);
    return std::pow(1 + incline * incline, 1.5) / bulge;
}

Vector3 WheelSurface::in_wheel(double x, double s) const {
    if (out_of_round_) {
        const ProfileCurve::Place here = profile_.place(s);
        return {x, base_y_ + here.at.y, below_axle(x, here, s).z};
    }
    const ProfilePoint point = profile_.at(s);
    const double rho = radius_ + point.z;
    return {x, base_y_ + point.y, std::sqrt(std::max(rho * rho - x * x, 0.0))};
}

Vector3 WheelSurface::slice_node(double angle, std::size_t index) const {
    const ProfilePoint at = out_of_round_->node(angle - pitch_, index);
    const double r = radius_ + at.z;
    return {r * std::sin(angle), base_y_ + at.y, r * std::cos(angle)};
}

std::pair<std::size_t, std::size_t> WheelSurface::seen_slice_nodes() const {
    const std::size_t count = out_of_round_->nodes();
    const auto y = [this](std::size_t index) { return frame_.outside(slice_node(0, index)).y; };
    std::size_t first = count / 2, last = first;
    while (first > 0 && y(first - 1) < y(first)) --first;
    while (last + 1 < count && y(last + 1) > y(last)) ++last;
    return {first, last};
}

// With F = z - sqrt(rho^2 - x^2), grad F is (x, -rho dz/dy, Z)/Z in the wheel's coordinates, with Z the square root.
// The distance to a body with slope p along x is least along x where (R grad F)_x + p (R grad F)_z = 0. That slope
// depends on x in the track, which is counted from the origin of the track and not from that of the wheel.
LocusPoint WheelSurface::locus(double s, double other) const {
    const ProfileCurve::Place here = profile_.place(s);
    const auto& [X, Y, Z] = frame_.axes;  // X.y is the y of the rotated x axis in the track.
    const double rho = radius_ + here.at.z, y = base_y_ + here.at.y;
    const double incline = here.slope.z / here.slope.y;
    const double incline_slope =
        (here.curving.z * here.slope.y - here.slope.z * here.curving.y) / (here.slope.y * here.slope.y);
    const double limit = radius_ / 2;
    double x = (rho * incline * Y.x - radius_ * Z.x) / X.x;
    if (other != 0)
        for (int iteration = 0; iteration < 4; ++iteration) {
            const double lift = X.z * x - Y.z * rho * incline + Z.z * rho;  // rho (R grad F)_z
            x = (rho * incline * Y.x - radius_ * Z.x - other * lift * (frame_.origin.x + Y.x * y + Z.x * rho)) /
                (X.x * (1 + other * lift));
        }
    const bool beyond = !(std::abs(x) <= limit);
    if (beyond) x = x > 0 ? limit : -limit;
    return locus_point(here, x, beyond ? 0 : Y.x / X.x * (here.slope.z * incline + rho * incline_slope));
}

// Solves the same condition by secants in x.
LocusPoint WheelSurface::locus(double s, const std::function<double(double x)>& other_slope) const {
    constexpr double settled = 1e-7;  // mm
    const ProfileCurve::Place here = profile_.place(s);
    const auto& [X, Y, Z] = frame_.axes;
    const double rho = radius_ + here.at.z, side = base_y_ + here.at.y, limit = radius_ / 2;
    const double incline = here.slope.z / here.slope.y;
    const auto excess = [&](double x) {
        const double height = std::sqrt(std::max(rho * rho - x * x, 1e-12));
        const double lift = X.z * x - Y.z * rho * incline + Z.z * height;
        const double x_in_track = frame_.origin.x + X.x * x + Y.x * side + Z.x * height;
        return x - (rho * incline * Y.x - height * Z.x - other_slope(x_in_track) * lift) / X.x;
    };
    double before = std::clamp(rho * incline * Y.x / X.x, -limit, limit), at_before = excess(before);
    double x = std::clamp(before - at_before, -limit, limit);
    for (int iteration = 0; iteration < 12 && std::abs(x - before) > settled; ++iteration) {
        const double at_x = excess(x);
        if (!std::isfinite(at_x) || at_x == at_before) break;
        const double next = std::clamp(x - at_x * (x - before) / (at_x - at_before), -limit, limit);
        before = x;
        at_before = at_x;
        x = next;
    }
    return locus_point(here, x, 0);
}

LocusPoint WheelSurface::locus_point(const ProfileCurve::Place& here, double x, double x_slope) const {
    const auto& [X, Y, Z] = frame_.axes;
    const double rho = radius_ + here.at.z;
    const double height = std::sqrt(std::max(rho * rho - x * x, 1e-12));
    const double height_slope = (rho * here.slope.z - x * x_slope) / height;
    return {frame_.outside({x, base_y_ + here.at.y, height}), x_slope * X + here.slope.y * Y + height_slope * Z};
}

}  // namespace contactd::geometry

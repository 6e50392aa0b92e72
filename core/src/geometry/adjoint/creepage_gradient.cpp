#include "geometry/adjoint/creepage_gradient.hpp"

#include <cmath>

#include "geometry/distance/heights.hpp"
#include "geometry/motion/surface_motion.hpp"

namespace contactd::geometry {
namespace {

constexpr Vector3 along{1, 0, 0};

double sign(double value) {
    return value < 0 ? -1 : 1;
}

}  // namespace

// The gradient by cross(a, b) in the direction v is cross(b, v) by a and cross(v, a) by b.
ByMotion by_motion(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                   const ContactPlace& place, const Creepages& by) {
    ByMotion sum;
    const double velocity = place.creepages.velocity;
    if (!(velocity > 0)) return sum;
    const Frame contact = contact_frame(place.reference);
    const Rotation& axes = wheel.wheelset().axes;
    const Vector3 on_wheel = contact.origin + place.approach * contact.axes.z;
    const Vector3 centre = centre_of_rotation(wheel, state), arm = on_wheel - centre;
    const SurfaceMotion rim = of_wheel(wheel, state, on_wheel), ground = of_rail(rail, state, contact.origin);
    const WheelsetVelocity& v = state.velocity;
    const Vector3 turning = axes * Vector3{v.roll, v.pitch, v.yaw}, pitching = axes * Vector3{0, v.pitch, 0};
    const Vector3 over = ground.velocity - rim.velocity, spin = ground.angular_velocity - rim.angular_velocity;

    const double of_rim = cross(pitching, arm).x, over_ground = -over.x - of_rim;
    const double by_velocity = by.velocity - (by.xi * dot(over, contact.axes.x) + by.eta * dot(over, contact.axes.y) +
                                              by.phi * dot(spin, contact.axes.z)) /
                                                 (velocity * velocity);
    const double by_rim = 0.5 * (sign(of_rim) - sign(over_ground)) * by_velocity;
    const Vector3 by_over = (by.xi / velocity) * contact.axes.x + (by.eta / velocity) * contact.axes.y -
                            (0.5 * sign(over_ground) * by_velocity) * along;
    const Vector3 by_spin = (by.phi / velocity) * contact.axes.z, by_rim_velocity = -1 * by_over;
    sum.reference.angle = (by.eta * dot(over, contact.axes.z) - by.phi * dot(spin, contact.axes.y)) / velocity;

    const Vector3 by_turning = cross(arm, by_rim_velocity) - by_spin, by_pitching = cross(arm, by_rim * along);
    const Vector3 by_arm = cross(by_rim_velocity, turning) + cross(by_rim * along, pitching);
    sum.wheelset.add(centre, -1 * by_arm);
    sum.wheelset.about = sum.wheelset.about + cross(turning, by_turning) + cross(pitching, by_pitching);
    const Vector3 by_rates = axes.rotated_back(by_turning);
    sum.state.velocity = {by_rim_velocity.x, by_rim_velocity.y, by_rim_velocity.z,
                          by_rates.x,        by_rates.z,        by_rates.y + axes.rotated_back(by_pitching).y};

    const WheelDeviation& w = state.wheel;
    const Vector3 moving = axes * Vector3{w.x_velocity, w.y_velocity, w.z_velocity};
    const Vector3 bending = axes * Vector3{w.roll_velocity, w.pitch_velocity, w.yaw_velocity};
    const Vector3 beside = on_wheel - wheel.profile_origin();
    const Vector3 by_bending = cross(beside, by_rim_velocity) - by_spin, by_beside = cross(by_rim_velocity, bending);
    const Vector3 by_moving = axes.rotated_back(by_rim_velocity), by_bending_rates = axes.rotated_back(by_bending);
    sum.wheelset.about = sum.wheelset.about + cross(moving, by_rim_velocity) + cross(bending, by_bending);
    sum.wheel.add(wheel.profile_origin(), -1 * by_beside);
    WheelDeviation& by_wheel = sum.state.wheel;
    by_wheel.x_velocity = by_moving.x, by_wheel.y_velocity = by_moving.y, by_wheel.z_velocity = by_moving.z;
    by_wheel.roll_velocity = by_bending_rates.x, by_wheel.pitch_velocity = by_bending_rates.y;
    by_wheel.yaw_velocity = by_bending_rates.z;

    const Vector3 tilting = state.rail.roll_velocity * along;
    const Vector3 by_place = cross(by_over, tilting);
    sum.rail.add(rail.frame().origin, -1 * by_place);
    sum.state.rail.y_velocity = by_over.y;
    sum.state.rail.z_velocity = by_over.z;
    sum.state.rail.roll_velocity = cross(contact.origin - rail.frame().origin, by_over).x + by_spin.x;

    const Vector3 by_on_wheel = by_arm + by_beside, by_origin = by_on_wheel + by_place;
    sum.approach = dot(by_on_wheel, contact.axes.z);
    sum.reference.angle -= place.approach * dot(by_on_wheel, contact.axes.y);
    sum.reference = {by_origin.x, by_origin.y, by_origin.z, sum.reference.angle};
    return sum;
}

}  // namespace contactd::geometry

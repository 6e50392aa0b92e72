// Describes the motion of points of wheel and rail in track coordinates.
#pragma once

#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Holds the velocity of a point of a rigid body (mm/s), and the body's rotation (rad/s).
struct SurfaceMotion {
    Vector3 velocity, angular_velocity;
};

/// Returns the point of the axle that a wheelset rotates about beside a wheel. The axle follows a wheel that is
/// displaced along the track, as if the whole wheelset were displaced.
inline Vector3 centre_of_rotation(const WheelSurface& wheel, const WheelRailState& state) {
    return wheel.wheelset().origin + state.wheel.x * wheel.wheelset().axes.x;
}

inline SurfaceMotion of_wheel(const WheelSurface& wheel, const WheelRailState& state, const Vector3& at) {
    const WheelsetVelocity& v = state.velocity;
    const Frame& wheelset = wheel.wheelset();
    const Vector3 angular_velocity = wheelset.axes * Vector3{v.roll, v.pitch, v.yaw};
    const Vector3 arm = at - centre_of_rotation(wheel, state);
    SurfaceMotion motion{Vector3{v.x, v.y, v.z} + cross(angular_velocity, arm), angular_velocity};
    const WheelDeviation& by = state.wheel;
    const Vector3 velocities{by.x_velocity, by.y_velocity, by.z_velocity};
    const Vector3 rates{by.roll_velocity, by.pitch_velocity, by.yaw_velocity};
    if (dot(velocities, velocities) + dot(rates, rates) == 0) return motion;
    const Vector3 more = wheelset.axes * rates;
    motion.velocity = motion.velocity + wheelset.axes * velocities + cross(more, at - wheel.profile_origin());
    motion.angular_velocity = motion.angular_velocity + more;
    return motion;
}

inline SurfaceMotion of_rail(const RailSurface& rail, const WheelRailState& state, const Vector3& at) {
    const Vector3 tilting{state.rail.roll_velocity, 0, 0};
    SurfaceMotion motion{
        Vector3{0, state.rail.y_velocity, state.rail.z_velocity} + cross(tilting, at - rail.frame().origin), tilting};
    if (rail.axle()) {
        const Vector3 rolling{0, state.roller_pitch, 0};
        motion.velocity = motion.velocity + cross(rolling, at - Vector3{0, 0, *rail.axle()});
        motion.angular_velocity = motion.angular_velocity + rolling;
    }
    return motion;
}

}  // namespace contactd::geometry

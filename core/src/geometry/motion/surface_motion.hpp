// How points of wheel and rail move, in track coordinates.
#pragma once

#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Velocity of a point of a rigid body (mm/s), and the body's rotation (rad/s).
struct SurfaceMotion {
    Vector3 velocity, angular_velocity;
};

inline SurfaceMotion of_wheel(const WheelSurface& wheel, const WheelRailState& state, const Vector3& at) {
    const WheelsetVelocity& v = state.velocity;
    const Vector3 angular_velocity = wheel.frame().axes * Vector3{v.roll, v.pitch, v.yaw};
    return {Vector3{v.x, v.y, v.z} + cross(angular_velocity, at - wheel.frame().origin), angular_velocity};
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

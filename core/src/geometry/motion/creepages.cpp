#include "geometry/motion/creepages.hpp"

#include <cmath>
#include <numbers>

#include "geometry/distance/heights.hpp"

namespace contactd::geometry {
namespace {

struct SurfaceMotion {
    Vector3 velocity, turning;
};

SurfaceMotion of_rail(const RailSurface& rail, const WheelRailState& state, const Vector3& at) {
    const Vector3 tilting{state.rail.roll_velocity, 0, 0};
    SurfaceMotion motion{
        Vector3{0, state.rail.y_velocity, state.rail.z_velocity} + cross(tilting, at - rail.frame().origin), tilting};
    if (rail.axle()) {
        const Vector3 rolling{0, state.roller_pitch, 0};
        motion.velocity = motion.velocity + cross(rolling, at - Vector3{0, 0, *rail.axle()});
        motion.turning = motion.turning + rolling;
    }
    return motion;
}

/// Of the wheel over the rail and of its rim about its axle, along x: what rolls.
struct RollingSpeeds {
    double over_ground, of_rim;

    double mean() const { return 0.5 * (std::abs(over_ground) + std::abs(of_rim)); }
    bool forwards() const { return std::abs(over_ground) >= std::abs(of_rim) ? over_ground >= 0 : of_rim <= 0; }
};

}  // namespace

Creepages creepages(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                    const ContactReference& reference, double approach) {
    const Frame contact = contact_frame(reference);
    const Rotation& axes = wheel.frame().axes;
    const WheelsetVelocity& v = state.velocity;
    const Vector3 on_wheel = contact.origin + approach * contact.axes.z;
    const Vector3 arm = on_wheel - wheel.frame().origin, turning = axes * Vector3{v.roll, v.pitch, v.yaw};
    const Vector3 wheel_velocity = Vector3{v.x, v.y, v.z} + cross(turning, arm);
    const SurfaceMotion ground = of_rail(rail, state, contact.origin);
    const double rim = cross(axes * Vector3{0, v.pitch, 0}, arm).x;
    RollingSpeeds speeds{wheel_velocity.x - ground.velocity.x - rim, rim};
    if (rail.axle()) speeds = {-ground.velocity.x, wheel_velocity.x};

    Creepages result;
    result.velocity = rail.axle() ? 0.5 * std::abs(ground.velocity.x + wheel_velocity.x) : speeds.mean();
    result.chi = speeds.forwards() ? 0 : std::numbers::pi;
    if (!(result.velocity > 0)) return {};
    const Vector3 over = ground.velocity - wheel_velocity;
    result.xi = dot(over, contact.axes.x) / result.velocity;
    result.eta = dot(over, contact.axes.y) / result.velocity;
    result.phi = dot(ground.turning - turning, contact.axes.z) / result.velocity;
    return result;
}

}  // namespace contactd::geometry

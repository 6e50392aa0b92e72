#include "wheel_rail/force_gradient.hpp"

#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include "contactd/error.hpp"
#include "geometry/distance/heights.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using geometry::Vector3;

void add(std::vector<ProfilePoint>& sum, double factor, const std::vector<ProfilePoint>& more) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i].y += factor * more[i].y;
        sum[i].z += factor * more[i].z;
    }
}

template <class Part>
void add(Part& sum, double factor, const Part& more, std::initializer_list<double Part::*> members) {
    for (double Part::* of : members) sum.*of += factor * (more.*of);
}

void add(WheelRailState& sum, double factor, const WheelRailState& more) {
    using Position = WheelsetPosition;
    using Velocity = WheelsetVelocity;
    using Wheel = WheelDeviation;
    using Rail = RailDeviation;
    add<Position>(sum.position, factor, more.position, {&Position::y, &Position::roll, &Position::yaw});
    add<Velocity>(sum.velocity, factor, more.velocity,
                  {&Velocity::x, &Velocity::y, &Velocity::z, &Velocity::roll, &Velocity::yaw, &Velocity::pitch});
    add<Wheel>(sum.wheel, factor, more.wheel,
               {&Wheel::x, &Wheel::y, &Wheel::z, &Wheel::roll, &Wheel::yaw, &Wheel::x_velocity, &Wheel::y_velocity,
                &Wheel::z_velocity, &Wheel::roll_velocity, &Wheel::pitch_velocity, &Wheel::yaw_velocity});
    add<Rail>(sum.rail, factor, more.rail,
              {&Rail::y, &Rail::z, &Rail::roll, &Rail::y_velocity, &Rail::z_velocity, &Rail::roll_velocity});
}

Vector3 force_of(const Wrench& wrench) {
    return {wrench.Fx, wrench.Fy, wrench.Fz};
}

Vector3 moment_of(const Wrench& wrench) {
    return {wrench.Mx, wrench.My, wrench.Mz};
}

}  // namespace

// In the track, F = R f and M = R m + o x F, with R the rotation by the angle and o the reference.
ByPatchForces by_patch_forces(const ContactReference& reference, const Wrench& track, const Wrench& by_track) {
    const geometry::Frame frame = geometry::contact_frame(reference);
    const Vector3 force = force_of(track), about_reference = moment_of(track) - cross(frame.origin, force);
    const Vector3 by_moment = moment_of(by_track), by_force = force_of(by_track) + cross(by_moment, frame.origin);
    const Vector3 f = frame.axes.rotated_back(by_force), m = frame.axes.rotated_back(by_moment);
    const Vector3 by_origin = cross(force, by_moment);
    return {{f.x, f.y, f.z, m.x, m.y, m.z},
            {by_origin.x, by_origin.y, by_origin.z, cross(force, by_force).x + cross(about_reference, by_moment).x}};
}

geometry::WheelGradient at_given_force(const geometry::WheelGradient& by, const geometry::WheelGradient& by_force) {
    const double stiffness = by_force.state.position.height();
    if (!(stiffness > 0))
        throw InvalidArgument("state.Fz", "has no gradients here, because the vertical force changes by " +
                                              number_text(stiffness) +
                                              " N per mm of height; prescribe position.z instead");
    const double factor = by.state.position.height() / stiffness;
    geometry::WheelGradient result = by;
    add(result.wheel, -factor, by_force.wheel);
    add(result.rail, -factor, by_force.rail);
    add(result.state, -factor, by_force.state);
    result.state.position.z = 0;
    result.state.Fz = factor;
    return result;
}

}  // namespace contactd

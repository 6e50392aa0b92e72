#include "rail_places.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"
#include "geometry/search/patch_grid.hpp"
#include "wheel_rail/mirror.hpp"

namespace contactd::cases {
namespace {

using geometry::Frame;
using geometry::Rotation;
using geometry::Vector3;

double roll_of(const Rotation& axes) {
    return std::atan2(-axes.z.y, axes.z.z);
}

double yaw_of(const Rotation& axes) {
    return std::atan2(axes.x.y, axes.x.x);
}

/// Returns the axes `inner` relative to the axes `outer`.
Rotation seen_by(const Rotation& outer, const Rotation& inner) {
    return {outer.rotated_back(inner.x), outer.rotated_back(inner.y), outer.rotated_back(inner.z)};
}

/// Returns the length along the profile from y = 0 (mm).
double length_along(const ProfileCurve& profile, double y) {
    return profile.arc_length(profile.s_at_y(y)) - geometry::arc_length_of_middle(profile);
}

/// Returns the centre of pressure in the axes of the patch.
Vector3 centre_of_pressure(const WheelRailPatch& patch) {
    const Grid& grid = patch.place.grid;
    double sum = 0, x = 0, y = 0;
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const double p = patch.solution.pressure[i];
            sum += p;
            x += p * grid.x(ix);
            y += p * grid.y(iy);
        }
    return sum > 0 ? Vector3{x / sum, y / sum, 0} : Vector3{};
}

struct Mirror {
    double side;

    Vector3 vector(const Vector3& a) const { return {a.x, side * a.y, a.z}; }
    Vector3 moment(const Vector3& a) const { return {side * a.x, a.y, side * a.z}; }
};

void put(std::array<double, 24>& values, std::size_t at, const Vector3& force, const Vector3& moment) {
    const std::array all{force.x, force.y, force.z, moment.x, moment.y, moment.z};
    std::ranges::copy(all, values.begin() + static_cast<std::ptrdiff_t>(at));
}

}  // namespace

WheelRailState found_state(WheelRailState state, const WheelRailSolution& solution) {
    state.position.z = solution.z;
    if (const auto& sunk = solution.rail_deflection) {
        state.rail.y += sunk->y;
        state.rail.z += sunk->z;
    }
    return state;
}

RailFrames frames_of(const RailOutlines& outlines, const WheelRailState& of_either_side) {
    const auto& [setup, profiles] = outlines;
    const WheelRailState state = setup.side == Side::left ? mirrored(of_either_side) : of_either_side;
    const geometry::WheelSurface wheel(profiles.wheel, setup.wheelset, state.position, state.wheel);
    const geometry::RailSurface surface(profiles.rail, setup.track, profiles.rail_origin, state.rail);
    RailFrames frames;
    frames.side = setup.side == Side::left ? -1 : 1;
    frames.wheelset = wheel.wheelset();
    frames.wheel = {wheel.profile_origin(), wheel.frame().axes};
    frames.rail = surface.frame();
    frames.roll_of_rail = roll_of(surface.frame().axes);
    return frames;
}

std::array<double, 38> location_of(const WheelRailPatch& patch, const RailOutlines& outlines,
                                   const RailFrames& frames) {
    const geometry::Profiles& profiles = outlines.profiles;
    const double side = frames.side;
    const ContactReference& reference = patch.place.reference;
    const Frame contact{{reference.x, side * reference.y, reference.z}, Rotation::roll(side * reference.angle)};
    const Vector3 at = contact.origin, on_rail = frames.rail.inside(at), on_wheel = frames.wheel.inside(at);
    const Vector3 on_wheelset = frames.wheelset.inside(at);
    Vector3 centre = centre_of_pressure(patch);
    centre.y *= side;
    centre = contact.outside(centre);
    const Vector3 wheel = frames.wheelset.inside(frames.wheel.origin);
    const Rotation &axes = frames.wheel.axes, rotated = seen_by(frames.wheelset.axes, axes);
    const auto angle = [&](const Frame& frame) { return side * roll_of(seen_by(frame.axes, contact.axes)); };
    return {at.x,
            side * at.y,
            at.z,
            reference.angle,
            on_rail.x,
            side * on_rail.y,
            on_rail.z,
            length_along(profiles.rail, on_rail.y),
            angle(frames.rail),
            on_wheel.x,
            side * on_wheel.y,
            on_wheel.z,
            -length_along(profiles.wheel, on_wheel.y),  // positive towards the flange
            angle(frames.wheel),
            centre.x,
            side * centre.y,
            0,
            0,
            0,
            0,
            frames.wheel.origin.x,
            side * frames.wheel.origin.y,
            frames.wheel.origin.z,
            side * roll_of(axes),
            side * yaw_of(axes),
            side * frames.rail.origin.y,
            frames.rail.origin.z,
            side * frames.roll_of_rail,
            0,
            on_wheelset.x,
            side * on_wheelset.y,
            on_wheelset.z,
            angle(frames.wheelset),
            wheel.x,
            side * wheel.y,
            wheel.z,
            side * roll_of(rotated),
            side * yaw_of(rotated)};
}

std::array<double, 24> wrenches_of(const WheelRailForces& forces, const RailFrames& frames) {
    const Mirror mirror{frames.side};
    const auto force_of = [&](const Wrench& wrench) { return mirror.vector({wrench.Fx, wrench.Fy, wrench.Fz}); };
    const auto moment_of = [&](const Wrench& wrench) { return mirror.moment({wrench.Mx, wrench.My, wrench.Mz}); };
    const Vector3 in_rail = force_of(forces.rail), about_rail = moment_of(forces.rail);
    const Vector3 in_wheelset = force_of(forces.wheelset);
    const Vector3 wheel = frames.wheelset.inside(frames.wheel.origin);
    const Vector3 about_wheel = moment_of(forces.wheelset) - cross(wheel, in_wheelset);
    const Rotation rotated = seen_by(frames.wheelset.axes, frames.wheel.axes);
    std::array<double, 24> values{};
    put(values, 0, mirror.vector(force_of(forces.track)), mirror.moment(frames.rail.axes * about_rail));
    put(values, 6, mirror.vector(in_wheelset), mirror.moment(about_wheel));
    put(values, 12, mirror.vector(in_rail), mirror.moment(about_rail));
    put(values, 18, mirror.vector(rotated.rotated_back(in_wheelset)), mirror.moment(rotated.rotated_back(about_wheel)));
    return values;
}

}  // namespace contactd::cases

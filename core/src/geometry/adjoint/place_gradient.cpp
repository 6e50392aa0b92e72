#include "geometry/adjoint/place_gradient.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "contactd/error.hpp"
#include "geometry/adjoint/creepage_gradient.hpp"
#include "geometry/distance/heights.hpp"
#include "geometry/placement/rail_origin_gradient.hpp"

namespace contactd::geometry {
namespace {

void refuse(bool unsupported, const char* field, const char* cure) {
    if (unsupported) throw InvalidArgument(field, std::string("has no gradients of a wheel; ") + cure);
}

void add_to(BodyCotangent& sum, const BodyCotangent& more) {
    sum.force = sum.force + more.force;
    sum.about = sum.about + more.about;
}

void add_to(ContactReference& sum, const ContactReference& more) {
    sum = {sum.x + more.x, sum.y + more.y, sum.z + more.z, sum.angle + more.angle};
}

void add_velocities(WheelRailState& sum, const WheelRailState& more) {
    using Velocity = WheelsetVelocity;
    for (double Velocity::* of :
         {&Velocity::x, &Velocity::y, &Velocity::z, &Velocity::roll, &Velocity::yaw, &Velocity::pitch})
        sum.velocity.*of += more.velocity.*of;
    using Wheel = WheelDeviation;
    for (double Wheel::* of : {&Wheel::x_velocity, &Wheel::y_velocity, &Wheel::z_velocity, &Wheel::roll_velocity,
                               &Wheel::pitch_velocity, &Wheel::yaw_velocity})
        sum.wheel.*of += more.wheel.*of;
    using Rail = RailDeviation;
    for (double Rail::* of : {&Rail::y_velocity, &Rail::z_velocity, &Rail::roll_velocity})
        sum.rail.*of += more.rail.*of;
}

/// Returns the derivative of coefficient_at() with respect to the angle.
double slope_of_friction(const WheelRailSetup& setup, double angle) {
    if (!setup.friction) return 0;
    const std::vector<FrictionAtAngle>& mu = setup.friction->mu;
    for (std::size_t i = 0; i + 1 < mu.size(); ++i)
        if (angle >= mu[i].angle && angle < mu[i + 1].angle)
            return (mu[i + 1].mu - mu[i].mu) / (mu[i + 1].angle - mu[i].angle);
    return 0;
}

/// Returns the gradient by a plane without its movement along itself, on which elements are held.
ContactReference across_plane(const ContactReference& by, double angle) {
    const Vector3 normal = Rotation::roll(angle).z;
    const double beside = dot(normal, {by.x, by.y, by.z});
    return {beside * normal.x, beside * normal.y, beside * normal.z, by.angle};
}

}  // namespace

void check_gradient(const WheelRailSetup& setup, const WheelRailState& state) {
    refuse(state.motion != WheelRailMotion::steady_rolling, "state.motion", "use steady_rolling");
    refuse(setup.track.roller_radius.has_value(), "setup.track.roller_radius", "use a rail instead of a roller");
    refuse(!setup.rail_slices.empty(), "setup.rail_slices", "use a rail that is uniform along the track");
    refuse(!setup.wheel_slices.empty(), "setup.wheel_slices", "use a round wheel");
    refuse(setup.track.springs.has_value(), "setup.track.springs", "use a rigid rail at the solved deflection");
    refuse(setup.conformal != Conformal::off, "setup.conformal", "set it to off");
    refuse(setup.wheel_surface != WheelSurfaceKind::exact, "setup.wheel_surface", "set it to exact");
    refuse(setup.patches.search != ContactSearch::locus, "setup.patches.search", "set it to locus");
    refuse(setup.rigid_slip != RigidSlipKind::plane, "setup.rigid_slip", "set it to plane");
    refuse(!has_distances(setup), "setup.model", "use a model with distances at its elements, such as full");
    refuse(setup.friction && setup.friction->along_profile && setup.friction->mu.size() > 1,
           "setup.friction.along_profile", "set it to false, or use one coefficient of friction");
}

PlaceGradient::PlaceGradient(const WheelRailSetup& setup, const WheelRailState& state, const WheelSurface& wheel,
                             const RailSurface& rail, GradientMode mode)
    : setup_(setup), state_(state), wheel_(wheel), rail_(rail), mode_(mode), sum_(wheel, rail) {
    check_gradient(setup, state);
}

// The approach is minus the least distance. Where elements are held while the reference moves, creepages refer to
// another point than elements do: xi changes by phi dt and eta by -phi dx, with t along the plane.
void PlaceGradient::add(const ContactPlace& place, const ByPlace& by) {
    const ByMotion motion = by_motion(wheel_, rail_, state_, place, by.creepages);
    std::vector<double> by_distance = by.distance;
    if (motion.approach != 0) {
        const std::vector<double> of_rail = rail_heights(rail_, place.reference, place.grid),
                                  of_wheel = wheel_heights(wheel_, place.reference, place.grid);
        const auto nx = static_cast<std::size_t>(place.grid.nx);
        std::size_t least = 0;
        double depth = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < of_wheel.size(); ++i)
            if (const double here = of_wheel[i] - of_rail[i / nx]; here > depth) depth = here, least = i;
        by_distance[least] -= motion.approach;
    }
    const ContactReference by_plane = add_by_distances(wheel_, rail_, place, by_distance, sum_);
    ContactReference by_reference = motion.reference;
    by_reference.angle += by.mu * slope_of_friction(setup_, place.reference.angle);
    if (mode_ == GradientMode::exact) {
        add_to(by_reference, by_plane);
        add_to(by_reference, by.reference);
    } else {
        const double angle = place.reference.angle, along = place.creepages.phi * by.creepages.xi;
        add_to(by_reference, across_plane(by_plane, angle));
        add_to(by_reference, across_plane(by.reference, angle));
        add_to(by_reference,
               {-place.creepages.phi * by.creepages.eta, along * std::cos(angle), along * std::sin(angle), 0});
    }
    add_by_reference(wheel_, rail_, place, setup_.patches.locus_step * setup_.dy, by_reference, sum_);
    add_to(wheelset_, motion.wheelset);
    add_to(sum_.wheel_body, motion.wheel);
    add_to(sum_.rail_body, motion.rail);
    add_velocities(by_velocities_, motion.state);
}

WheelGradient PlaceGradient::result() const {
    WheelGradient result{{}, {}, by_velocities_};
    WheelRailState& state = result.state;
    const Frame& wheelset = wheel_.wheelset();
    const BodyCotangent& wheel = sum_.wheel_body;
    BodyCotangent both = wheel;
    add_to(both, wheelset_);
    const Vector3 about_centre = both.about_point(wheelset.origin);
    state.position.y = both.force.y;
    state.position.z = both.force.z;
    state.position.roll = about_centre.x;
    state.position.yaw = dot(about_centre, wheelset.axes.z);
    // The axle, about which the wheelset rotates, follows the wheel along x only.
    const Vector3 moved = wheelset.axes.rotated_back(wheel.force),
                  about_profile = wheel.about_point(wheel_.profile_origin());
    state.wheel.x = moved.x + dot(wheelset_.force, wheelset.axes.x);
    state.wheel.y = moved.y;
    state.wheel.z = moved.z;
    state.wheel.roll = dot(about_profile, wheelset.axes.x);
    state.wheel.yaw = dot(about_profile, wheel_.frame().axes.z);
    const BodyCotangent& rail = sum_.rail_body;
    state.rail.y = rail.force.y;
    state.rail.z = rail.force.z;
    state.rail.roll = rail.about_point(rail_.frame().origin).x;
    CurveCotangent curve = sum_.rail;
    add_by_rail_origin(setup_.track, {rail.force.y, rail.force.z}, curve);
    result.wheel = sum_.wheel.by_points();
    result.rail = curve.by_points();
    return result;
}

}  // namespace contactd::geometry

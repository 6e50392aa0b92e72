#include "wheel_rail/resultants.hpp"

#include <cmath>
#include <cstddef>

namespace contactd {
namespace {

using geometry::Frame;
using geometry::Vector3;

double value_at(const std::vector<double>& values, std::size_t i) {
    return values.empty() ? 0 : values[i];
}

struct Sum {
    Vector3 force, about;

    void add(const Vector3& at, const Vector3& more) {
        force = force + more;
        about = about + cross(at, more);
    }
};

/// Returns the change of a traction on a level plane if the surface rises by `slope` along x: per area of the plane a
/// pressure acts along (-slope, 0, 1), and friction along (1, 0, slope).
Vector3 beside_level(const Vector3& traction, double slope, SlopeForces forces) {
    if (forces == SlopeForces::none) return {};
    return {-slope * traction.z, 0, forces == SlopeForces::all ? slope * traction.x : 0};
}

/// Returns the moment of the pressures about x and y, in contact coordinates, and that about z of the solution.
Vector3 moment(const Grid& grid, const ContactSolution& solution, bool simplified) {
    Vector3 about{0, 0, solution.forces.Mz};
    if (simplified) return about;
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const double force = solution.pressure[i] * grid.element_area();
            about.x += grid.y(iy) * force;
            about.y -= grid.x(ix) * force;
        }
    return about;
}

/// Returns the forces due to the slopes along the track, in contact coordinates.
Sum along_slopes(const Grid& grid, const ContactSolution& solution, bool simplified, const FollowedSlopes& followed) {
    const auto& [slopes, which] = followed;
    const Forces& forces = solution.forces;
    if (simplified) return {beside_level({forces.Fx, forces.Fy, forces.Fn}, slopes.at_reference, which), {}};
    Sum sum;
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const Vector3 traction{value_at(solution.traction_x, i), 0, solution.pressure[i]};
            sum.add({grid.x(ix), grid.y(iy), 0}, grid.element_area() * beside_level(traction, slopes.at(i), which));
        }
    return sum;
}

/// Returns the forces at the reference, in the track.
Sum of_plane(const ContactPlace& place, const ContactSolution& solution, bool simplified,
             const FollowedSlopes& followed) {
    const geometry::Rotation axes = geometry::contact_frame(place.reference).axes;
    const Forces& forces = solution.forces;
    Sum sum{axes * Vector3{forces.Fx, forces.Fy, forces.Fn}, axes * moment(place.grid, solution, simplified)};
    if (followed.slopes.is_level() || followed.forces == SlopeForces::none) return sum;
    const Sum more = along_slopes(place.grid, solution, simplified, followed);
    return {sum.force + axes * more.force, sum.about + axes * more.about};
}

Sum of_rows(const ContactPlace& place, const ContactSolution& solution, const FollowedSlopes& followed) {
    const Grid& grid = place.grid;
    const bool is_level = followed.slopes.is_level();
    Sum sum;
    std::size_t i = 0;
    for (const ContactRow& row : place.rows) {
        const geometry::Rotation axes = geometry::Rotation::roll(row.angle);
        const double cosine = std::cos(row.angle - place.reference.angle);
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            Vector3 traction{value_at(solution.traction_x, i), value_at(solution.traction_y, i), solution.pressure[i]};
            if (!is_level)
                traction = traction + beside_level(traction, followed.slopes.at(i) * cosine, followed.forces);
            sum.add({grid.x(ix), row.y - place.reference.y, row.z - place.reference.z},
                    grid.element_area() * (axes * traction));
        }
    }
    return sum;
}

/// Returns a force at a point and its moment about it, given in the track, in the axes of a frame.
Wrench seen_from(const Frame& frame, const Vector3& point, const Vector3& force, const Vector3& about) {
    const Vector3 f = frame.axes.rotated_back(force);
    const Vector3 m = frame.axes.rotated_back(about + cross(point - frame.origin, force));
    return {f.x, f.y, f.z, m.x, m.y, m.z};
}

Wrench sum(const Wrench& a, const Wrench& b) {
    return {a.Fx + b.Fx, a.Fy + b.Fy, a.Fz + b.Fz, a.Mx + b.Mx, a.My + b.My, a.Mz + b.Mz};
}

}  // namespace

WheelRailForces resultants(const ContactPlace& place, const ContactSolution& solution, bool simplified,
                           const FollowedSlopes& followed, const Frame& rail, const Frame& wheelset) {
    const Vector3 at = geometry::contact_frame(place.reference).origin;
    const auto [force, about] =
        place.rows.empty() ? of_plane(place, solution, simplified, followed) : of_rows(place, solution, followed);
    return {seen_from({}, at, force, about), seen_from(rail, at, force, about), seen_from(wheelset, at, force, about)};
}

WheelRailForces sum(const WheelRailForces& a, const WheelRailForces& b) {
    return {sum(a.track, b.track), sum(a.rail, b.rail), sum(a.wheelset, b.wheelset)};
}

}  // namespace contactd

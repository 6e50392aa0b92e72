#include "wheel_rail/resultants.hpp"

#include <cstddef>

#include "geometry/distance/heights.hpp"

namespace contactd {
namespace {

using geometry::Frame;
using geometry::Vector3;

/// Returns the moment of the pressures about x and y, in contact coordinates; about z as the solution has it.
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

struct Sum {
    Vector3 force, about;
};

/// At the reference, in the track.
Sum of_plane(const ContactPlace& place, const ContactSolution& solution, bool simplified) {
    const geometry::Rotation axes = geometry::contact_frame(place.reference).axes;
    const Forces& forces = solution.forces;
    return {axes * Vector3{forces.Fx, forces.Fy, forces.Fn}, axes * moment(place.grid, solution, simplified)};
}

Sum of_rows(const ContactPlace& place, const ContactSolution& solution) {
    const Grid& grid = place.grid;
    const auto at = [](const std::vector<double>& values, std::size_t i) { return values.empty() ? 0 : values[i]; };
    Sum sum;
    std::size_t i = 0;
    for (const ContactRow& row : place.rows) {
        const geometry::Rotation axes = geometry::Rotation::roll(row.angle);
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const Vector3 traction{at(solution.traction_x, i), at(solution.traction_y, i), solution.pressure[i]};
            const Vector3 force = grid.element_area() * (axes * traction);
            const Vector3 from_reference{grid.x(ix), row.y - place.reference.y, row.z - place.reference.z};
            sum.force = sum.force + force;
            sum.about = sum.about + cross(from_reference, force);
        }
    }
    return sum;
}

/// A force at a point and its moment about it, all in the track, seen from a frame.
Wrench seen_from(const Frame& frame, const Vector3& point, const Vector3& force, const Vector3& about) {
    const Vector3 f = frame.axes.turned_back(force);
    const Vector3 m = frame.axes.turned_back(about + cross(point - frame.origin, force));
    return {f.x, f.y, f.z, m.x, m.y, m.z};
}

Wrench sum(const Wrench& a, const Wrench& b) {
    return {a.Fx + b.Fx, a.Fy + b.Fy, a.Fz + b.Fz, a.Mx + b.Mx, a.My + b.My, a.Mz + b.Mz};
}

}  // namespace

WheelRailForces resultants(const ContactPlace& place, const ContactSolution& solution, bool simplified,
                           const Frame& rail, const Frame& wheelset) {
    const Vector3 at = geometry::contact_frame(place.reference).origin;
    const auto [force, about] = place.rows.empty() ? of_plane(place, solution, simplified) : of_rows(place, solution);
    return {seen_from({}, at, force, about), seen_from(rail, at, force, about), seen_from(wheelset, at, force, about)};
}

WheelRailForces sum(const WheelRailForces& a, const WheelRailForces& b) {
    return {sum(a.track, b.track), sum(a.rail, b.rail), sum(a.wheelset, b.wheelset)};
}

}  // namespace contactd

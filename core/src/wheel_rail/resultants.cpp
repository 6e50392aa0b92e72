#include "wheel_rail/resultants.hpp"

#include <cstddef>

#include "geometry/distance/heights.hpp"

namespace contactd {
namespace {

using geometry::Frame;
using geometry::Vector3;

/// Of the pressures about x and y, in contact coordinates; about z as the solution has it.
Vector3 moment(const Grid& grid, const ContactSolution& solution, bool quick_model) {
    Vector3 about{0, 0, solution.forces.Mz};
    if (quick_model) return about;
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const double force = solution.pressure[i] * grid.element_area();
            about.x += grid.y(iy) * force;
            about.y -= grid.x(ix) * force;
        }
    return about;
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

WheelRailForces resultants(const ContactReference& reference, const Grid& grid, const ContactSolution& solution,
                           bool quick_model, const Frame& rail, const Frame& wheelset) {
    const Frame contact = geometry::contact_frame(reference);
    const Forces& forces = solution.forces;
    const Vector3 force = contact.axes * Vector3{forces.Fx, forces.Fy, forces.Fn};
    const Vector3 about = contact.axes * moment(grid, solution, quick_model);
    return {seen_from({}, contact.origin, force, about), seen_from(rail, contact.origin, force, about),
            seen_from(wheelset, contact.origin, force, about)};
}

WheelRailForces sum(const WheelRailForces& a, const WheelRailForces& b) {
    return {sum(a.track, b.track), sum(a.rail, b.rail), sum(a.wheelset, b.wheelset)};
}

}  // namespace contactd

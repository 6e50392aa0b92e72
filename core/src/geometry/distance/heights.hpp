// Heights of wheel and rail over a contact plane, along its normal, at the elements of a grid.
#pragma once

#include <limits>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Where a surface does not stand above the plane.
inline constexpr double no_height = std::numeric_limits<double>::quiet_NaN();

/// Axes of the contact in the track.
inline Frame contact_frame(const ContactReference& reference) {
    return {{reference.x, reference.y, reference.z}, Rotation::roll(reference.angle)};
}

/// Of the rail's surface, shape [ny, nx] (mm), or [ny] of a rail that is the same all along.
std::vector<double> rail_heights(const RailSurface& rail, const ContactReference& reference, const Grid& grid);

/// Of the wheel's surface, shape [ny, nx] (mm).
std::vector<double> wheel_heights(const WheelSurface& wheel, const ContactReference& reference, const Grid& grid);

/// The same of a wheel that is straight between the nodes of a mesh on it: as wide as the elements, along x and along
/// its profile, around the contact's reference.
std::vector<double> meshed_wheel_heights(const WheelSurface& wheel, const ContactReference& reference,
                                         const Grid& grid);

}  // namespace contactd::geometry

// Defines contact on a surface that is curved along y: the positions of its strips of elements, and their common
// direction.
#pragma once

#include <vector>

#include "contactd/section.hpp"

namespace contactd {

/// Each row of the grid is a strip of the lower body's surface, and rows are numbered along its tangent s. dy is the
/// arc length of a strip, and y of the grid is a distance along the surface. x, y and z of an element are the axes of
/// its strip's frame; gaps, pressures and tractions are along these axes. The upper body's strips lie opposite.
struct ContactColumns {
    std::vector<StripFrame> frames{};  ///< shape [ny]
    /// The direction points from the lower body to the upper body, as an angle from +z (rad) like those of the frames.
    /// An approach delta closes the gap of a strip by delta cos(angle - direction), and the normal force is along the
    /// direction. Every strip faces it: the cosine is at least least_facing.
    double direction = 0;
    /// The axis of spin and rotation, along the direction, passes through this point. Moments are about this axis. The
    /// point lies at x = 0 of the grid.
    SectionPoint origin{};

    bool operator==(const ContactColumns&) const = default;
};

inline constexpr double least_facing = 0.01;

/// Holds the resultant of all tractions on the upper body in the axes of the section: force (N), and moment about the
/// origin of the strips (N mm).
struct Resultant {
    double Fx = 0, Fy = 0, Fz = 0;
    double Mx = 0, My = 0, Mz = 0;

    bool operator==(const Resultant&) const = default;
};

}  // namespace contactd

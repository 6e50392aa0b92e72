// Contact on a surface that is curved along y: positions of its strips of elements, and their common direction.
#pragma once

#include <vector>

#include "contactd/section.hpp"

namespace contactd {

/// Rows of the grid are strips of the lower body's surface, numbered along its tangent s: dy is their arc length, and
/// y of the grid a distance along the surface. x, y and z of an element are the axes of its strip's frame; gaps,
/// pressures and tractions are along these. The upper body's strips lie opposite.
struct ContactColumns {
    std::vector<StripFrame> frames{};  ///< shape [ny]
    /// Direction from the lower body towards the upper one, from which that one approaches: angle from +z (rad) as in
    /// frames. An approach delta closes the gap of a strip by delta cos(angle - direction), and the normal force is
    /// along it. Every strip faces it: the cosine is at least least_facing.
    double direction = 0;
    /// Point on the axis of spin and rotation along the direction; moments are about it. x = 0 of the grid.
    SectionPoint origin{};

    bool operator==(const ContactColumns&) const = default;
};

inline constexpr double least_facing = 0.01;

/// The resultant of all tractions on the upper body: force (N), and moment about the origin of the strips (N mm), in
/// the axes of the section.
struct Resultant {
    double Fx = 0, Fy = 0, Fz = 0;
    double Mx = 0, My = 0, Mz = 0;

    bool operator==(const Resultant&) const = default;
};

}  // namespace contactd

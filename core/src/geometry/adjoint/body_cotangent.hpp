// Holds the gradient of a number by small rigid motions of a body.
#pragma once

#include "geometry/placement/vector3.hpp"

namespace contactd::geometry {

/// The gradient by translations acts like a force, and that by rotations about the track's origin like its moment.
struct BodyCotangent {
    Vector3 force{}, about{};

    /// Adds the gradient by the position of a point that moves with the body.
    void add(const Vector3& at, const Vector3& by_position) {
        force = force + by_position;
        about = about + cross(at, by_position);
    }
    /// Returns the gradient by rotations about a point.
    Vector3 about_point(const Vector3& point) const { return about - cross(point, force); }
};

}  // namespace contactd::geometry

// Converts gradients by the forces of a wheel on its rail.
#pragma once

#include "contactd/wheel_rail_solution.hpp"
#include "geometry/adjoint/place_gradient.hpp"

namespace contactd {

/// Holds the gradient by the forces of a patch in contact coordinates, with moments about the reference, and by the
/// reference, whose angle rotates them.
struct ByPatchForces {
    Wrench contact;
    ContactReference reference;
};

/// Returns the gradient by the forces of a plane patch on a rail that is uniform along the track from that by its
/// forces in the track's coordinates. `track` holds the latter forces.
ByPatchForces by_patch_forces(const ContactReference& reference, const Wrench& track, const Wrench& by_track);

/// Converts a gradient at a given height to one at a given vertical force: g - g_z/F_z f, where `by_force` is the
/// gradient f of that force. That by the force is in state.Fz, and that by the height vanishes. Throws
/// InvalidArgument ("state.Fz") if the force does not increase as the wheel is lowered.
geometry::WheelGradient at_given_force(const geometry::WheelGradient& by, const geometry::WheelGradient& by_force);

}  // namespace contactd

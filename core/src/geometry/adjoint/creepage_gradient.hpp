// Computes the gradient of a number by the motion of a wheel and its place from that by its creepages.
#pragma once

#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/adjoint/body_cotangent.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Holds the gradient by what determines the creepages. `wheelset` and `wheel` are by motions of their frames; `state`
/// holds only that by velocities.
struct ByMotion {
    ContactReference reference;
    double approach = 0;
    BodyCotangent wheelset, wheel, rail;
    WheelRailState state;
};

/// `by` holds the gradient by xi, eta, phi and the rolling velocity at the place of a rail that is not a roller. This
/// is the transpose of creepages() in steady rolling.
ByMotion by_motion(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                   const ContactPlace& place, const Creepages& by);

}  // namespace contactd::geometry

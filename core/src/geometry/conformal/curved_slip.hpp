// Computes rigid slip of a contact that is curved across the track, element by element.
#pragma once

#include <vector>

#include "contactd/friction.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

struct CurvedSlip {
    Creepages creepages;  ///< creepages that fit the slip of the elements in contact best (least squares)
    RigidSlip rest;       ///< remaining slip of all elements; zero where a surface is missing
};

/// Holds heights of both surfaces at the elements (mm); for a rail that is uniform along x, those of its rows.
struct SurfaceHeights {
    std::vector<double> rail, wheel;
};

/// Describes the conventions of a reference program. The solver evaluates spin this far ahead (mm) of the middles of
/// elements, for which slip is given, so that part is omitted from the rest. In shifts, surfaces may lean as if they
/// passed through the contact at 1 mm/s.
struct SlipConvention {
    double spin_ahead = 0;
    bool leans_in_shifts = false;
};

/// Returns the slip from the velocities of both surfaces at their positions, along x as the surfaces lean and along
/// each row, over the velocity of the wheelset, or that of the creepages if the wheelset stands. `gap` and `approach`
/// determine the elements in contact. `rail_share` is the rail's part in the direction in which both lean, 0 to 1.
/// `from` are the creepages of the plane, which determine the rolling direction. In shifts, surfaces lean only by the
/// convention.
CurvedSlip curved_slip(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                       const ContactPlace& place, const SurfaceHeights& heights, const std::vector<double>& gap,
                       double rail_share, const Creepages& from, const SlipConvention& convention = {});

}  // namespace contactd::geometry

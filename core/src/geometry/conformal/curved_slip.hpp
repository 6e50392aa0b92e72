// Rigid slip of a contact that is curved across the track, element by element.
#pragma once

#include <vector>

#include "contactd/friction.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

struct CurvedSlip {
    Creepages creepages;  ///< those that fit the slip of the elements in contact best (least squares)
    RigidSlip rest;       ///< of all elements, beside them; zero where a surface is missing
};

/// Of both surfaces at the elements (mm); those of a rail that is the same all along, of its rows.
struct SurfaceHeights {
    std::vector<double> rail, wheel;
};

/// As a reference program has it: where the solver takes spin ahead (mm) of the middles of elements, of which slip is,
/// this is left out of the rest; and surfaces lean in shifts, too, as if they ran through the contact by 1 mm/s.
struct SlipConvention {
    double spin_ahead = 0;
    bool leans_in_shifts = false;
};

/// Velocities of both surfaces where they are, along x as the surfaces lean and along each row, over the velocity
/// of the wheelset, or the creepages' where it stands. `gap` and `approach` say which elements are in contact;
/// `rail_share` is the rail's part in the direction in which both lean, 0 to 1. `from` are the creepages of the plane:
/// which way it rolls. In shifts surfaces lean by a convention only.
CurvedSlip curved_slip(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                       const ContactPlace& place, const SurfaceHeights& heights, const std::vector<double>& gap,
                       double rail_share, const Creepages& from, const SlipConvention& convention = {});

}  // namespace contactd::geometry

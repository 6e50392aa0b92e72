// Creepages at a contact from the motion of a wheelset: rigid-body kinematics.
#pragma once

#include <vector>

#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Where solvers take the spin of creepages: so many steps ahead of the middles of the elements.
inline constexpr double spin_offset = 1.0 / 6;  // errs least on grids as they are used (docs/contact.md)

/// Whether there are creepages that a contact problem takes: none where the rolling velocity is next to nothing, or
/// what slides beside it is beyond 1e9 times as fast.
bool is_rolling(const Creepages& creepages);

/// Taken at the reference: that of the rail, and of the wheel by `approach` deeper. The rolling velocity is the mean of
/// the speeds of the wheel over the ground and of its rim about the axle, or of rim and roller; creepages are zero
/// where it is.
Creepages creepages(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                    const ContactReference& reference, double approach);

/// Speed (mm/s) at which the surface of the rail passes through the contact at the reference, as above: that of the
/// wheel over the ground, which the contact goes along with, or of the roller's surface.
double rail_speed(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                  const ContactReference& reference, double approach);

/// Slip over the rows of a grid, at x = 0 of the contact: of the rail's surface and the wheel's where they are, seen
/// along the mean of both. It is zero in rows where one of them is missing.
struct RowSlip {
    double along = 0, across = 0;  ///< as creepages
    double spin = 0;               ///< (rad/mm)
};
std::vector<RowSlip> row_slips(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                               const ContactReference& reference, const Creepages& creepages, const Grid& grid);

}  // namespace contactd::geometry

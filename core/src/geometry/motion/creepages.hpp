// Computes creepages at a contact from the motion of a wheelset by rigid-body kinematics.
#pragma once

#include <vector>

#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Solvers evaluate the spin of creepages this number of steps ahead of the middles of the elements.
inline constexpr double spin_offset = 1.0 / 6;  // has the smallest error on typical grids (docs/contact.md)

/// Returns whether a contact problem accepts the creepages. It does not if the rolling velocity is nearly zero, or if
/// the sliding velocity is more than 1e9 times as large.
bool is_rolling(const Creepages& creepages);

/// Returns the creepages at the reference: that of the rail, and of the wheel deeper by `approach`. The rolling
/// velocity is the mean of the speeds of the wheel over the ground and of its rim about the axle, or of rim and roller.
/// If it is zero, so are the creepages.
Creepages creepages(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                    const ContactReference& reference, double approach);

/// Returns the speed (mm/s) at which the surface of the rail passes through the contact at the reference, as above. It
/// is the speed of the wheel over the ground, which the contact follows, or that of the roller's surface.
double rail_speed(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                  const ContactReference& reference, double approach);

/// Holds slip over the rows of a grid, at x = 0 of the contact. It is the slip of the rail's and the wheel's surface at
/// their positions, seen along the mean of both. It is zero in rows without one of them.
struct RowSlip {
    double along = 0, across = 0;  ///< as creepages
    double spin = 0;               ///< (rad/mm)
};
std::vector<RowSlip> row_slips(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                               const ContactReference& reference, const Creepages& creepages, const Grid& grid);

}  // namespace contactd::geometry

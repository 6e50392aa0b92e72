// Defines rolling contact: particles travel through a given contact area (Kalker 1990, chapter 5), slip and carry
// tractions.
#pragma once

#include <span>
#include <vector>

#include "contact/tangential/tangential.hpp"
#include "contactd/friction.hpp"
#include "contactd/grid.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/step_operator.hpp"

namespace contactd {

/// Describes the bodies for rolling solvers: the particle that is now at x was at x + step one step ago.
struct RollingBodies {
    const InfluenceOperator& influence;  ///< A on the grid
    const StepOperator& increment;       ///< C on the grid, for the step
    const Grid& grid;
    double step_x = 0, step_y = 0;  ///< dq (cos chi, sin chi) (mm), not both zero
};

/// Returns dq (xi - phi y, eta + phi x) for the creepages and spin of `rolling`, spin_offset dq ahead of the element
/// centres.
RigidSlip rigid_slip(const Grid& grid, const Rolling& rolling, double dq);
/// Returns (x - rotation y, y + rotation x) at the element centres.
RigidSlip rigid_slip(const Grid& grid, const Shift& shift);

struct RollingSolution : TangentialSolution {
    std::vector<double> slip_x, slip_y;  ///< over the step (mm), 0 outside contact; the relative slip is slip/dq
    /// Hold the plastic flow of a layer over the step, along the tractions (mm), and the yield stress behind it
    /// (N/mm^2). They are empty without a layer that yields.
    std::vector<double> flow_x, flow_y, yield_stress;
};

/// Holds resultants of tractions on the upper body.
struct TangentialForces {
    double Fx = 0, Fy = 0;  ///< (N)
    double Mz = 0;          ///< sum (x py - y px) dx dy, about the origin of the grid's coordinates (N mm)
};
TangentialForces tangential_forces(const Grid& grid, std::span<const double> traction_x,
                                   std::span<const double> traction_y);

}  // namespace contactd

// Finds the uniform rigid slip that goes with prescribed tangential forces, around any solver that finds the forces for
// a rigid slip: shift, transient step, steady rolling.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "contact/support/pair.hpp"
#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// The prescribed forces, and the start of the search. The force on the upper body opposes the slip.
struct PrescribedForces {
    std::optional<double> Fx, Fy;  ///< (N); a component without one keeps its rigid slip
    double largest = 0;            ///< force in full slip, sum of g dx dy (N)
    double wx = 0, wy = 0;         ///< rigid slip (mm): an estimate where the force is prescribed; zero serves
    double scale = 0;              ///< rigid slip that makes most of the contact slip (mm); slip_scale() estimates it
    /// n of |F| = largest (1 - (1 - w/scale)^n), the usual shape of the force. The search is by the inverse of that
    /// curve, so that its slope does not vanish where the contact slips.
    double exponent = shift_exponent;
    const char* field = "friction.force";  ///< named where the force cannot be carried

    static constexpr double shift_exponent = 1.5;  ///< Cattaneo (Johnson 1985, (7.42))
    static constexpr double rolling_exponent = 3;  ///< Vermeulen and Johnson (Johnson 1985, (8.48))
};

/// Forces for one rigid slip, and whether the solver reached the tolerance it was asked for.
struct ForcesAtSlip {
    double Fx = 0, Fy = 0;
    bool converged = false;
};

/// Solves with the uniform rigid slip (wx, wy) (mm) to a relative tolerance of the tractions. Should start from the
/// tractions of its last call, and keeps its solution: the last call belongs to the rigid slip that is returned.
using SolveForForces = std::function<ForcesAtSlip(double wx, double wy, double tolerance)>;

struct RigidSlipForForces {
    double wx = 0, wy = 0;    ///< (mm)
    SolverEvidence evidence;  ///< iterations: calls of the solver; residual: |F - prescribed| / largest
};

/// The force that friction carries with a rigid slip of its own. From there to the largest one, which it never quite
/// reaches, the force of any slip that is long enough would do, to the tolerance of the search (or to 1e-3).
double largest_force_with_a_slip(double largest, const SolverSettings& settings);

/// Throws InvalidArgument naming `field` for forces that are not below largest_force_with_a_slip.
void require_reachable(const PrescribedForces& prescribed, const SolverSettings& settings);

/// By the usual shape of the force, for a contact at rest before (mm); zero along components without a force.
Pair expected_rigid_slip(const PrescribedForces& prescribed);

/// Broyden's method, and line searches where that gets on slowly: the force falls monotonically with the rigid slip.
/// Ends where the forces are met to
/// `settings.tolerance` of the largest force by a solution of that tolerance; otherwise returns the best it found, not
/// converged. Throws as require_reachable, and Cancelled.
RigidSlipForForces find_rigid_slip(const PrescribedForces& prescribed, const SolverSettings& settings,
                                   const SolveForForces& solve, Observer& observer);

/// Displacement (mm) in the direction of a traction that equals `bound` everywhere: for a sphere exactly the shift at
/// which all of the contact slips.
double slip_scale(const InfluenceOperator& influence, std::span<const double> bound);

}  // namespace contactd

// Searches the uniform rigid slip for prescribed tangential forces, with any solver that computes the forces for a
// rigid slip: shift, transient step, steady rolling.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "contact/support/pair.hpp"
#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Describes the prescribed forces, and the start of the search. The force on the upper body opposes the slip.
struct PrescribedForces {
    std::optional<double> Fx, Fy;  ///< (N); a component without one keeps its rigid slip
    double largest = 0;            ///< force in full slip, sum of g dx dy (N)
    double wx = 0, wy = 0;         ///< rigid slip (mm): an estimate if the force is prescribed; zero is sufficient
    double scale = 0;              ///< rigid slip that makes most of the contact slip (mm); slip_scale() estimates it
    /// Holds n of |F| = largest (1 - (1 - w/scale)^n), the usual shape of the force. The search uses the inverse of
    /// that curve, so that its slope does not vanish in full slip.
    double exponent = shift_exponent;
    const char* field = "friction.force";  ///< field in errors if friction cannot carry the force

    static constexpr double shift_exponent = 1.5;  ///< Cattaneo (Johnson 1985, (7.42))
    static constexpr double rolling_exponent = 3;  ///< Vermeulen and Johnson (Johnson 1985, (8.48))
};

/// Holds the forces for one rigid slip, and whether the solver reached the requested tolerance.
struct ForcesAtSlip {
    double Fx = 0, Fy = 0;
    bool converged = false;
};

/// Solves with the uniform rigid slip (wx, wy) (mm) to a relative tolerance of the tractions. It should start from the
/// tractions of its last call and keep its solution, because the last call belongs to the rigid slip that is returned.
using SolveForForces = std::function<ForcesAtSlip(double wx, double wy, double tolerance)>;

struct RigidSlipForForces {
    double wx = 0, wy = 0;    ///< (mm)
    SolverEvidence evidence;  ///< iterations: calls of the solver; residual: |F - prescribed| / largest
};

/// Returns the largest force that determines the rigid slip. Between this force and the largest one, which is never
/// quite reached, any sufficiently large slip would produce the force to the tolerance of the search (or to 1e-3).
double largest_force_with_a_slip(double largest, const SolverSettings& settings);

/// Throws InvalidArgument, which names `field`, for forces that are not below largest_force_with_a_slip.
void require_reachable(const PrescribedForces& prescribed, const SolverSettings& settings);

/// Returns the rigid slip by the usual shape of the force, for a contact previously at rest (mm). It is zero along
/// components without a force.
Pair expected_rigid_slip(const PrescribedForces& prescribed);

/// Searches by Broyden's method, and by line searches if that converges slowly, because the force decreases
/// monotonically with the rigid slip. Ends if a solution to `settings.tolerance` has the forces to that fraction of the
/// largest force. Otherwise returns the best slip, not converged. Throws as require_reachable, and Cancelled.
RigidSlipForForces find_rigid_slip(const PrescribedForces& prescribed, const SolverSettings& settings,
                                   const SolveForForces& solve, Observer& observer);

/// Returns the displacement (mm) in the direction of a traction that equals `bound` everywhere. For a sphere, it is
/// exactly the shift at which all of the contact slips.
double slip_scale(const InfluenceOperator& influence, std::span<const double> bound);

}  // namespace contactd

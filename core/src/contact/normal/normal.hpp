// Solves normal contact by NORM (Kalker 1990; paper section 4.1; Vollebregt 2014): an active set around conjugate
// gradients.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"

namespace contactd {

struct NormalSolution {
    std::vector<double> pressure;  ///< (N/mm^2), > 0 in contact, 0 outside
    double approach = 0;           ///< computed by solve_normal_force (mm); 0 if it was prescribed
    SolverEvidence evidence;       ///< residual: ||A p + h||_rms / ||h||_rms over the contact (section 4.1)
};

/// Returns an estimate of the pressures, or an empty one if there is none. The function may be null.
using PressureEstimate = std::function<std::vector<double>()>;

/// Finds p >= 0 with A_zz p + h = 0 where p > 0 and A_zz p + h >= 0 elsewhere. `gap` is h minus the approach (mm,
/// negative where the undeformed bodies overlap), one entry per element. `initial` is empty or an estimate of p; if
/// that is not near, `closed_form` is called for one. Without overlap, p = 0 has converged. The evidence reports a
/// missed tolerance. Throws Cancelled through the observer and InvalidArgument for arrays of the wrong size.
NormalSolution solve_normal(const InfluenceOperator& influence, std::span<const double> gap,
                            const SolverSettings& settings, std::span<const double> initial, Observer& observer,
                            const PressureEstimate& closed_form = {});

/// Solves with a prescribed force: finds p and the approach delta with sum(p) = `pressure_sum`, which is Fn / element
/// area, for the gap h = `undeformed_distance` - delta (mm). There is always a solution: at most, all elements are in
/// contact. Without a force, p = 0 and delta is the least undeformed distance, where bodies just touch. Also throws
/// InvalidArgument ("Fn") for a negative force or one that is not finite.
NormalSolution solve_normal_force(const InfluenceOperator& influence, std::span<const double> undeformed_distance,
                                  double pressure_sum, const SolverSettings& settings, std::span<const double> initial,
                                  Observer& observer, const PressureEstimate& closed_form = {});

/// Selects the border rows beyond which a contact may extend. It does not extend beyond the row where a body ends at
/// its own edge.
struct BorderRows {
    bool first = true, last = true;
};

/// Counts elements with pressure in the first or last column, or in these rows. If there are any, the contact may
/// extend beyond the potential contact area, and the solution is that of bodies cut off there.
int border_elements(const Grid& grid, std::span<const double> pressure, const BorderRows& rows = {});

}  // namespace contactd

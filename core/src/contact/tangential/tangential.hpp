// Computes tractions under Coulomb friction in a given contact area by TangCG (Zhao, Vollebregt, Oosterlee 2014; paper
// section 4.2).
#pragma once

#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"

namespace contactd {

struct TangentialSolution {
    std::vector<double> traction_x, traction_y;  ///< (N/mm^2), 0 outside contact
    std::vector<ElementState> element_division;
    /// The residual is the larger of ||p_new - p|| / ||p_new|| (section 4.2) and the estimated error, which is the
    /// preconditioned residual relative to the tractions. A small update alone may only mean slow progress.
    SolverEvidence evidence;
};

/// Solves a shift problem: slip s = A_t p + w per element; s = 0 and |p| <= g in adhesion, |p| = g and s opposite to p
/// in slip. `bound` is g = mu p_n (N/mm^2), zero outside the contact; `rigid_x`, `rigid_y` are the rigid slip w per
/// element (mm); `initial_*` are empty or an estimate of the tractions. Throws as solve_normal.
TangentialSolution solve_tangential(const InfluenceOperator& influence, std::span<const double> bound,
                                    std::span<const double> rigid_x, std::span<const double> rigid_y,
                                    const SolverSettings& settings, std::span<const double> initial_x,
                                    std::span<const double> initial_y, Observer& observer);

}  // namespace contactd

// Solves rolling with creepage but no spin by Vermeulen's and Johnson's theory (Vermeulen and Johnson 1964; Johnson,
// section 8.4), in closed form.
#pragma once

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/forces_by_motion.hpp"

namespace contactd {

/// Solves rolling. The adhesion area is an ellipse similar to the contact area, k times as large, which touches it at
/// the leading edge; F = mu Fn (1 - k^3), and 1 - k is proportional to the creepage. The theory assumes quasi-identical
/// half-spaces, steady rolling along an axis of the ellipse, tractions parallel to the force, and no spin. Slip is not
/// opposite to the traction between leading edge and adhesion area, which makes the force of small creepages too large
/// against Kalker's coefficients: by 6 per cent for a long contact (a/b = 10), by 28 for a short one (1/10). The theory
/// determines slip only in adhesion: slip_x and slip_y stay empty. In line contact the theory is Carter's, and exact:
/// the adhesion area is a strip, F = mu Fn (1 - k^2).
///
/// `rolling` prescribes xi and eta, or Fx and Fy, or one of each. Throws InvalidArgument ("friction.rolling.phi") for
/// spin, ("friction.rolling.chi") for a direction that is not an axis of the ellipse, and ("friction.rolling.force")
/// for a force that friction cannot carry.
EllipticFriction vermeulen_johnson(const Grid& grid, const EllipticContact& contact, double mu, const Rolling& rolling);

/// Differentiates the forces at known creepages; derivatives by spin are not available. `contact` is not empty, mu > 0,
/// and `rolling` has been solved.
ForcesByMotion vermeulen_johnson_by_motion(const EllipticContact& contact, double mu, const Rolling& rolling);

}  // namespace contactd

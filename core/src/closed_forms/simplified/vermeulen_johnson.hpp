// Vermeulen's and Johnson's theory of rolling with creepage but no spin (Vermeulen and Johnson 1964; Johnson,
// section 8.4): quick, closed form.
#pragma once

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/forces_by_motion.hpp"

namespace contactd {

/// The adhesion area is an ellipse similar to the contact area, k times as large, which touches it at the leading edge;
/// F = mu Fn (1 - k^3), and 1 - k is proportional to the creepage. Assumed: half-spaces, quasi-identical; steady
/// rolling along an axis of the ellipse; tractions parallel to the force; no spin. Slip is not opposite to the traction
/// between leading edge and adhesion area, which makes the force of small creepages too large: by 6 per cent where the
/// contact is long (a/b = 10) to 28 where it is short (1/10), against Kalker's coefficients. Slip is told by the theory
/// nowhere but in adhesion: slip_x and slip_y stay empty.
/// In line contact the theory is Carter's, and exact: the adhesion area is a strip, F = mu Fn (1 - k^2).
/// `rolling` prescribes xi and eta, or Fx and Fy, or one of each. Throws InvalidArgument ("friction.rolling.phi") for
/// spin, ("friction.rolling.chi") for a direction that is no axis of the ellipse, ("friction.rolling.force") for a
/// force that friction cannot carry.
EllipticFriction vermeulen_johnson(const Grid& grid, const EllipticContact& contact, double mu, const Rolling& rolling);

/// Differentiates the forces at known creepages, none by spin. `contact` is not empty, mu > 0, and `rolling` has been
/// solved.
ForcesByMotion vermeulen_johnson_by_motion(const EllipticContact& contact, double mu, const Rolling& rolling);

}  // namespace contactd

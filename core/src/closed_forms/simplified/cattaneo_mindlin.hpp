// Cattaneo's and Mindlin's theory of shifts (Johnson, section 7.2; Mindlin 1949 for ellipses): a Hertzian contact is
// shifted once, from rest and without tractions, slip starts at its edge.
#pragma once

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/forces_by_motion.hpp"

namespace contactd {

/// The traction is the difference of two that are spread like Hertz's pressure, over the ellipse and over a similar
/// one, k times as large, that adheres: k^3 = 1 - F/(mu Fn). Assumed: half-spaces, quasi-identical; tractions parallel
/// to the force everywhere, so that slip is not exactly opposite to them (an error of a few per cent of the shift, none
/// for nu = 0); constant mu. Shift and force have each its own compliance along x and y.
/// In line contact k^2 = 1 - F/(mu Fn), and the shift follows from the datum.
/// `shift` prescribes x and y, or Fx and Fy, or one of each; beyond the adhesion limit the whole area slips.
/// The theory does not tell the slip: slip_x and slip_y stay empty. Throws InvalidArgument ("friction.rotation") for a
/// rotation and ("friction.force") for a force that friction cannot carry.
EllipticFriction cattaneo_mindlin(const Grid& grid, const EllipticContact& contact, double mu, const Shift& shift);

/// Differentiates the forces at a known shift, none by rotation. `contact` is not empty, mu > 0, and `shift` has been
/// solved.
ForcesByMotion cattaneo_mindlin_by_motion(const EllipticContact& contact, double mu, const Shift& shift);

/// d ln(shift)/d ln(Fn) where the same part of the contact slips, mu > 0; 2/3 of ellipses.
double cattaneo_mindlin_exponent(const EllipticContact& contact, double mu, const Shift& shift);

}  // namespace contactd

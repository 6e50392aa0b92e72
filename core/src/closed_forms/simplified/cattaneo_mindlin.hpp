// Solves shifts by Cattaneo's and Mindlin's theory (Johnson, section 7.2; Mindlin 1949 for ellipses): a Hertzian
// contact is shifted once, from rest and without tractions, and slip starts at its edge.
#pragma once

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/forces_by_motion.hpp"

namespace contactd {

/// Solves a shift. The traction is the difference of two that are distributed like Hertz's pressure, over the ellipse
/// and over a similar one, k times as large, that adheres: k^3 = 1 - F/(mu Fn). The theory assumes quasi-identical
/// half-spaces, a constant mu, and tractions parallel to the force everywhere. Therefore slip is not exactly opposite
/// to the tractions, an error of a few per cent of the shift, and none for nu = 0. Shift and force each have their own
/// compliance along x and y. In line contact k^2 = 1 - F/(mu Fn), and the shift follows from the datum. `shift`
/// prescribes x and y, or Fx and Fy, or one of each; beyond the adhesion limit the whole area slips. The theory does
/// not determine the slip: slip_x and slip_y stay empty. Throws InvalidArgument ("friction.rotation") for a rotation,
/// and ("friction.force") for a force that friction cannot carry.
EllipticFriction cattaneo_mindlin(const Grid& grid, const EllipticContact& contact, double mu, const Shift& shift);

/// Differentiates the forces at a known shift; derivatives by rotation are not available. `contact` is not empty, mu >
/// 0, and `shift` has been solved.
ForcesByMotion cattaneo_mindlin_by_motion(const EllipticContact& contact, double mu, const Shift& shift);

/// Returns d ln(shift)/d ln(Fn) for the same slipping part of the contact, with mu > 0. It is 2/3 for ellipses.
double cattaneo_mindlin_exponent(const EllipticContact& contact, double mu, const Shift& shift);

}  // namespace contactd

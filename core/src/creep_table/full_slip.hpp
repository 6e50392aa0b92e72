// Computes the two limits of creep forces over an ellipse that need no contact solve: the creepages of full slip, which
// scale creepages, and the forces at infinite creepage.
#pragma once

#include <array>

namespace contactd::creep_table {

/// Holds three values along x, y and about z: creepages (xi, eta, phi c) or forces (Fx, Fy, Mz/c), with c^2 = ab.
using Triple = std::array<double, 3>;

/// Returns the creepages of full slip under a semi-ellipsoidal traction, in units of mu Fn/(G c^2). With ab = 1 and
/// r^2 = a^2 cos^2 t + b^2 sin^2 t,
///     xi_f  = 3b/(2 pi) I_0^pi (1 - nu + nu a^2 cos^2 t/r^2) sin^2 t/r dt,
///     eta_f = 3b/(2 pi) I_0^pi (1 - nu a^2 cos^2 t/r^2) sin^2 t/r dt,
/// and phi_f = 1/sqrt((b/xi_f)^2 + (a/eta_f)^2). a_over_b is between 1/50 and 50.
Triple full_slip(double a_over_b, double nu);

/// Returns the forces over mu Fn as the creepages grow without bound in this direction: the integral of the Hertzian
/// pressure times the direction of the rigid slip (xi - phi y, eta + phi x). They have the sign of the creepages. Their
/// error is below 1e-6 unless the pole of the slip lies at the edge of the contact, where it is below 1e-5.
Triple forces_at_infinite_creepage(double a_over_b, const Triple& direction);

}  // namespace contactd::creep_table

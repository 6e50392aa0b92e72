// Solves normal contact by virtual penetration: patches and pressures from the overlap of undeformed surfaces, in
// microseconds to milliseconds, without elastic equations.
#pragma once

#include <span>

#include "closed_forms/penetration_contact.hpp"
#include "contactd/contact.hpp"

namespace contactd {

/// Returns pressures by problem.normal_model, from the distance h (mm) and d, the approach minus the least distance;
/// the force may be prescribed instead.
///
/// kp (Piotrowski and Kik 2008) uses rows where h < 0.55 d, and in each a half ellipse sqrt(l^2 - x^2) over its length
/// 2 l.
///
/// kpec (Piotrowski, Liu, Bruni 2017) is similar, with eps(y) instead of 0.55: eps d = A a^2 - (A a^2 - B b^2) ((y -
/// ym)/b)^2, between 0 and d, which yields Hertz's ellipse for an ellipse. A is the curvature along x where the
/// surfaces are nearest, B that of the region h < d/2 across, a and b are Hertz's for both and d. In both models, one
/// factor of all pressures follows from the elastic displacement where the surfaces are nearest, which is d.
///
/// analyn (Sichani, Enblom, Berg 2014) solves Hertz's problem of d for the A(y) and B(y) of each row. The row is in
/// contact if dy = d - d/(B b^2) h(y) > 0, with the half-length a sqrt(dy/d), and Hertz's largest pressure for A, B,
/// dy.
///
/// Bodies are half-spaces. Rows are along x. kpec and analyn reproduce Hertz's contacts; kp has an error of 4 per cent.
/// prescribed_pressures.hpp describes elliptic and parabolic. Warns if a model is outside its range: eps limited to 1,
/// B that is not convex. Throws InvalidArgument ("grid.ny") for analyn with fewer than three rows, and ("Fn") for a
/// force that requires an approach above the smallest radius.
PenetrationContact penetration_contact(const ContactProblem& problem, std::span<const double> distance);

}  // namespace contactd

// Normal contact by virtual penetration: patches and pressures from the overlap of undeformed surfaces, in microseconds
// to milliseconds, without elastic equations.
#pragma once

#include <span>

#include "closed_forms/penetration_contact.hpp"
#include "contactd/contact.hpp"

namespace contactd {

/// Pressures by problem.normal_model, from the distance h (mm) and d, the approach less the least distance; the force
/// may be given instead.
/// kp (Piotrowski and Kik 2008): rows where h < 0.55 d, in each a half ellipse sqrt(l^2 - x^2) over its length 2 l.
/// kpec (Piotrowski, Liu, Bruni 2017): the same, with eps(y) in place of 0.55: eps d = A a^2 - (A a^2 - B b^2)
/// ((y - ym)/b)^2, between 0 and d, which gives the ellipse of Hertz for one; A is the curvature along x where the
/// surfaces are nearest, B that of the region h < d/2 across, a and b are Hertz's for both and d. Of both one factor of
/// all pressures follows from the elastic displacement where the surfaces are nearest, which is d.
/// analyn (Sichani, Enblom, Berg 2014): each row has its own A(y) and B(y) and what Hertz makes of these for d: contact
/// where dy = d - d/(B b^2) h(y) > 0, of half-length a sqrt(dy/d), with Hertz's largest pressure for A, B, dy.
/// Bodies are half-spaces. Rows lie along x. Hertz's contacts come out as Hertz has them, by kpec and analyn; kp errs
/// by 4 per cent. elliptic and parabolic are those of prescribed_pressures.hpp. Warns where a model leaves what it is
/// made for: eps cut at 1, B that is not convex. Throws InvalidArgument ("grid.ny") for analyn of fewer than three
/// rows, and ("Fn") for a force that no approach of less than the smallest radius brings.
PenetrationContact penetration_contact(const ContactProblem& problem, std::span<const double> distance);

}  // namespace contactd

// Computes prescribed pressures over an ellipse, or over two halves of ellipses.
#pragma once

#include "closed_forms/penetration_contact.hpp"

namespace contactd {

/// Prescribes p0 sqrt(e), p0 = 3 Fn/(2 pi a b), for normal_model elliptic, and 2 Fn/(pi a b) e for parabolic, with e =
/// 1 - x^2/a^2 - ((y - y0)/w)^2 where positive. The ellipse is Hertz's of the gap under the load, with y0 = 0 and w =
/// b. For half ellipses, y0 is where they join, w the semi-axis of each (SDEC: Piotrowski, Liu, Bruni 2017), and b the
/// mean. Pressures are samples at the element centres, so that their sum is Fn within the error of the grid. The
/// approach is Hertz's, for half ellipses that of one of the mean width. Throws InvalidArgument as hertz_of does.
PenetrationContact prescribed_contact(const ContactProblem& problem);

}  // namespace contactd

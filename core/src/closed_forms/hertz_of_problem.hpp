// Hertz's contact of a problem's gap under its load.
#pragma once

#include "contactd/contact.hpp"
#include "hertz.hpp"

namespace contactd {

/// The gap is no array; of half ellipses it is the contact of an ellipse of their mean width. Throws InvalidArgument
/// ("gap.paraboloid.Rx", "Ry") where it is flat or concave, and as hertz.hpp does.
HertzContact hertz_of(const ContactProblem& problem);

/// Throws InvalidArgument of `field` for a radius that is flat or concave.
void check_is_curved(double radius, const char* field);

}  // namespace contactd

// The undeformed distance of a problem, whichever way its gap is given, and Hertz's contact of it.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact.hpp"
#include "hertz.hpp"

namespace contactd {

/// The paraboloid of the gap, with the radii that semi-axes stand for under the load; nothing for an array, and of
/// half ellipses that of their mean width. `problem` has a gap and a load.
std::optional<Paraboloid> paraboloid_of(const ContactProblem& problem);

/// h at the element centres, shape [ny, nx] (mm).
std::vector<double> undeformed_distance(const ContactProblem& problem);

/// The gap is no array; of half ellipses it is the contact of an ellipse of their mean width. Throws InvalidArgument
/// ("gap.paraboloid.Rx", "Ry") where it is flat or concave, and as hertz.hpp does.
HertzContact hertz_of(const ContactProblem& problem);

/// Throws InvalidArgument of `field` for a radius that is flat or concave.
void check_is_curved(double radius, const char* field);

}  // namespace contactd

// Computes the undeformed distance of a problem from any form of its gap, and its Hertzian contact.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact.hpp"
#include "hertz.hpp"

namespace contactd {

/// Returns the paraboloid of the gap, with the radii that semi-axes represent under the load. It is nothing for an
/// array, and for half ellipses that of their mean width. `problem` has a gap and a load.
std::optional<Paraboloid> paraboloid_of(const ContactProblem& problem);

/// Returns h at the element centres, shape [ny, nx] (mm).
std::vector<double> undeformed_distance(const ContactProblem& problem);

/// Returns the Hertzian contact of a gap that is not an array. For half ellipses it is that of an ellipse of their mean
/// width. Throws InvalidArgument ("gap.paraboloid.Rx", "Ry") if the gap is flat or concave, and as hertz.hpp does.
HertzContact hertz_of(const ContactProblem& problem);

/// Throws InvalidArgument of `field` for a radius that is flat or concave.
void check_is_curved(double radius, const char* field);

}  // namespace contactd

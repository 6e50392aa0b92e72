// The undeformed distance of a problem, whichever way its gap is given.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// The paraboloid of the gap, with the radii that semi-axes stand for under the load; nothing for an array, and of
/// half ellipses that of their mean width. `problem`
/// has a gap and a load.
std::optional<Paraboloid> paraboloid_of(const ContactProblem& problem);

/// h at the element centres, shape [ny, nx] (mm).
std::vector<double> undeformed_distance(const ContactProblem& problem);

}  // namespace contactd

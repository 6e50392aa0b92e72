// Computes the start of NORM without an estimate of the pressures.
#pragma once

#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Returns Hertz's pressures under the load of the problem, shape [ny, nx] (N/mm^2), of the bodies' materials, whatever
/// their shape. Returns nothing if his theory does not apply: the gap is an array, concave, or flat in both directions;
/// there is no load; or a table of the pair is given, without materials. Also returns nothing for the approach of a
/// line contact, which depends on the far field, and for a contact that contains no centre of an element.
std::vector<double> hertz_start(const ContactProblem& problem);

}  // namespace contactd

// Where NORM starts when nothing better is known of the pressures.
#pragma once

#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Hertz's pressures under the load of the problem, shape [ny, nx] (N/mm^2), of the bodies' materials whatever their
/// shape. Empty where his theory has none: the gap is an array, concave, or flat in both directions; nothing presses
/// the bodies together; a table of the pair says nothing of materials; an approach of a line contact, which depends on
/// what is far away; or a contact that no element has its centre in.
std::vector<double> hertz_start(const ContactProblem& problem);

}  // namespace contactd

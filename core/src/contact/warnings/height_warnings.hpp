// Heights of surfaces that are probably in micrometres or in metres.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// A sentence about a gap by elements that is steeper than 45 degrees nearly everywhere, as in micrometres, or that is
/// nearly flat and pressed flat as a whole, as in metres.
std::vector<std::string> height_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

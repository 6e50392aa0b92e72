// Creates warnings about surface heights that are probably in micrometres or in metres.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Returns a warning about a gap, given for each element, that is steeper than 45 degrees nearly everywhere (heights in
/// micrometres), or nearly flat and in contact as a whole (heights in metres).
std::vector<std::string> height_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

// Rolling that is too slow for what it is solved with, as if its velocity were in m/s.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// A sentence about friction that hardly falls with the slip velocity.
std::vector<std::string> slow_rolling_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

// Creates warnings about rolling that is too slow for its friction law, as with a velocity in m/s.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Returns a warning about friction that hardly falls with the slip velocity.
std::vector<std::string> slow_rolling_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

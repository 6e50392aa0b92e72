// Likely mistakes of units in contact problems: magnitudes that no contact has.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Sentences about moduli, loads, strengths, heights, coefficients and creepages that are out of every proportion, and
/// about a slip law at velocities that hardly affect it.
std::vector<std::string> unit_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

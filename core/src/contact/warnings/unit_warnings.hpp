// Creates warnings about magnitudes that no contact has, and which are probably in another unit.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Returns warnings about implausible moduli, loads, strengths, heights, coefficients and creepages, and about a slip
/// law at velocities that hardly affect it.
std::vector<std::string> unit_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

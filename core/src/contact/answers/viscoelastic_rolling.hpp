// Computes the additional answers of rolling viscoelastic bodies: the resistance to rolling, and warnings about the
// speed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"

namespace contactd {

/// Returns the resistance to rolling, or nothing without contact. Slopes are central differences.
std::optional<RollingResistance> rolling_resistance(const ContactProblem& problem, const InfluenceOperator& influence,
                                                    const ContactSolution& solution);

/// Returns warnings if V tau is so short or so long that its limit is as accurate.
std::vector<std::string> creep_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

// What bodies that creep as they roll have beside elastic ones: a resistance to rolling, and limits of the speed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"

namespace contactd {

/// The resistance to rolling; nothing without contact. Slopes are central differences.
std::optional<RollingResistance> rolling_resistance(const ContactProblem& problem, const InfluenceOperator& influence,
                                                    const ContactSolution& solution);

/// Warns where V tau is so short or so long that a limit of it is as good: sentences.
std::vector<std::string> creep_warnings(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd

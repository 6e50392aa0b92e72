#include "contact/warnings/slow_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "types/number_text.hpp"
#include "types/units/plausibility.hpp"

namespace contactd {
namespace {

using Sentences = std::vector<std::string>;

/// Returns the largest slip velocity of the last step (mm/s). In rolling, slip is relative. Models without slip in the
/// elements use the velocity of the creepage.
double largest_slip_velocity(const Motion& motion, const ContactSolution& solution) {
    double slip = 0;
    for (std::size_t i = 0; i < solution.slip_x.size(); ++i)
        slip = std::max(slip, std::hypot(solution.slip_x[i], solution.slip_y[i]));
    const auto* rolling = std::get_if<Rolling>(&motion);
    if (rolling == nullptr) return slip / std::get<Shift>(motion).duration;
    if (solution.slip_x.empty()) slip = std::hypot(rolling->xi, rolling->eta);
    return slip * rolling->velocity;
}

/// Returns whether rolling is so slow that the velocity is probably in m/s or km/h.
bool rolls_slowly(const ContactProblem& problem) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    return rolling != nullptr && rolling->velocity < slowest_vehicle;
}

void warn_of_friction_that_never_falls(const ContactProblem& problem, const ContactSolution& solution,
                                       Sentences& warnings) {
    // The fraction of the law's slip velocity below which a faster motion was probably intended.
    const double hardly_any = rolls_slowly(problem) ? 0.02 : 1e-3;
    if (!problem.friction || !problem.friction->kinetic || solution.elements.slip == 0) return;
    const double largest = largest_slip_velocity(solution.motion.value_or(problem.motion), solution);
    const double in_law = problem.friction->kinetic->slip_velocity;
    if (largest >= hardly_any * in_law) return;
    const bool rolls = std::holds_alternative<Rolling>(problem.motion);
    const bool of_creepage = rolls && solution.slip_x.empty();
    warnings.push_back(
        std::string("Friction hardly falls: the ") +
        (of_creepage ? "velocity of the creepage (xi, eta)" : "largest slip velocity") + " is " + short_text(largest) +
        " mm/s, but friction.kinetic.slip_velocity is " + number_text(in_law) + " mm/s. Slip velocities follow from " +
        (rolls ? "friction.rolling.velocity (mm/s)" : "friction.duration (s)") + ", which is 1 by default.");
}

}  // namespace

std::vector<std::string> slow_rolling_warnings(const ContactProblem& problem, const ContactSolution& solution) {
    Sentences warnings;
    warn_of_friction_that_never_falls(problem, solution, warnings);
    return warnings;
}

}  // namespace contactd

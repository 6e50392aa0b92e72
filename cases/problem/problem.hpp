// From what a program has set to a contact problem of core.
#pragma once

#include <functional>

#include "contactd/contact.hpp"
#include "given/given.hpp"

namespace contactd::cases {

/// A case that was solved, which the next one may continue from.
struct LastCase {
    const ContactProblem& problem;
    const ContactSolution& solution;
};

/// Throws NotCovered for what is missing, contradicts itself, or is not covered. Tangential forces that are prescribed
/// are relative to a normal force, which only the solve knows where the approach is prescribed: `normal_force` tells
/// it for such a problem without friction.
ContactProblem problem_of(const Given& settings, const LastCase* last,
                          const std::function<double(const ContactProblem&)>& normal_force);

/// Throws NotCovered: no step starts from the pressures of the last one alone.
[[noreturn]] void refuse_history_of_pressures();

}  // namespace contactd::cases

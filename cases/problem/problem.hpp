// Converts the values of a case to a contact problem of core.
#pragma once

#include <functional>

#include "contactd/contact.hpp"
#include "given/given.hpp"

namespace contactd::cases {

/// Holds a solved case, from which the next one may continue.
struct LastCase {
    const ContactProblem& problem;
    const ContactSolution& solution;
};

/// Returns the problem. Throws NotCovered for missing, inconsistent and unsupported values. Prescribed tangential
/// forces are relative to the normal force. If the approach is prescribed, `normal_force` returns this force for the
/// problem without friction.
ContactProblem problem_of(const Given& settings, const LastCase* last,
                          const std::function<double(const ContactProblem&)>& normal_force);

/// Throws NotCovered for a step that starts from the pressures of the last one without its tractions (P = 1).
[[noreturn]] void refuse_history_of_pressures();

}  // namespace contactd::cases

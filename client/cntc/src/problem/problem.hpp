// From what a program has set to a contact problem of core.
#pragma once

#include <functional>

#include "contactd/contact.hpp"
#include "problem/settings.hpp"

namespace contactd::cntc {

/// A case that was solved, which the next one may continue from.
struct LastCase {
    const ContactProblem& problem;
    const ContactSolution& solution;
};

/// Throws Refused for what is missing, contradicts itself, or is not covered. Tangential forces that are prescribed
/// are relative to a normal force, which only the solve knows where the approach is prescribed: `normal_force` tells
/// it for such a problem without friction.
ContactProblem problem_of(const Settings& settings, const LastCase* last,
                          const std::function<double(const ContactProblem&)>& normal_force);

/// Throws Refused: no step starts from the pressures of the last one alone.
[[noreturn]] void refuse_history_of_pressures();

/// Spin is evaluated dq/6 ahead of the element's centre.
inline constexpr double spin_offset = 1.0 / 6;

}  // namespace contactd::cntc

// Handles tractions of a contact problem on its grid between its solves.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/contact.hpp"
#include "tangential_step.hpp"

namespace contactd {

/// Makes tractions from arrays, of which empty ones represent zero.
Tractions make_tractions(std::size_t n, const std::vector<double>& pressure, const std::vector<double>& x,
                         const std::vector<double>& y);

/// Returns the relative change of the tractions, of all three components together.
double relative_change(const Tractions& now, const Tractions& before);

/// Returns the problem's estimate, completed by the end of the previous step. A steady state has no previous step, so
/// its tractions may start from anything.
Tractions first_estimate(const ContactProblem& problem);

}  // namespace contactd

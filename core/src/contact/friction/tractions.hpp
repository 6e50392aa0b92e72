// Tractions of a contact problem on its grid, between its solves.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/contact.hpp"
#include "tangential_step.hpp"

namespace contactd {

/// Makes tractions of arrays that may be empty, which stands for zero.
Tractions make_tractions(std::size_t n, const std::vector<double>& pressure, const std::vector<double>& x,
                         const std::vector<double>& y);

/// How far the tractions are from those before, all three components together.
double relative_change(const Tractions& now, const Tractions& before);

/// Returns the problem's estimate, completed by the end of the step before. A steady state has no step before: its
/// tractions may be anything.
Tractions first_estimate(const ContactProblem& problem);

}  // namespace contactd

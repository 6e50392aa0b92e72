// Computes derivatives of a solved contact by implicit differentiation of its equations.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Adds `derivatives`, `pressure_by_approach` and their evidence to a converged solution of the solvers, whose slip is
/// in mm. If the equations do not reach their tolerance, or without contact, adds only a warning. Throws Cancelled.
void differentiate(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer,
                   ContactSolution& solution);

}  // namespace contactd

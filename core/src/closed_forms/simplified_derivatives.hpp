// Derivatives of the simplified models.
#pragma once

#include "contactd/contact.hpp"
#include "elliptic_contact.hpp"

namespace contactd {

/// Of a solution by the problem's simplified model, its contact not empty: exact, for fastsim those of its algorithm.
/// The gap is held also where semi-axes gave it.
Derivatives simplified_derivatives(const ContactProblem& problem, const EllipticContact& contact,
                                   const ContactSolution& solution);

}  // namespace contactd

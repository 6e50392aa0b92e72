// Computes derivatives of the simplified models.
#pragma once

#include "closed_forms/elliptic_contact.hpp"
#include "contactd/contact.hpp"

namespace contactd {

/// Differentiates a solution by the problem's simplified model, whose contact is not empty. The derivatives are exact;
/// for fastsim they are those of its algorithm. The gap is fixed, even if semi-axes gave it.
Derivatives simplified_derivatives(const ContactProblem& problem, const EllipticContact& contact,
                                   const ContactSolution& solution);

}  // namespace contactd

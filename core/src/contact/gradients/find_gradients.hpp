// Computes the gradients of a solved contact from the solutions of the transposed equations.
#pragma once

#include "contactd/contact_gradients.hpp"

namespace contactd {

/// As contact_gradients, for a valid problem without regions, operators that contain all sheets, and a solution with
/// contact whose slip is in mm.
ContactGradients find_gradients(const ContactProblem& problem, const ContactInfluence& influence,
                                const ContactSolution& solution, const std::vector<Cotangents>& outputs,
                                const std::vector<GradientInput>& by, Observer& observer);

}  // namespace contactd

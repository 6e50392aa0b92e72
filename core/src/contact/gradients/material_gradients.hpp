// Computes gradients with respect to the moduli of half-spaces.
#pragma once

#include <vector>

#include "adjoint.hpp"
#include "contactd/gradients.hpp"

namespace contactd {

struct GradientsByMaterials {
    std::optional<GradientByMaterial> upper, lower;  // absent if the body is rigid
};

// Returns the gradients of each output. All coefficients of a half-space are a/G + b nu/G, so that two pairs of
// operators give them exactly. Throws Cancelled.
std::vector<GradientsByMaterials> by_materials(const ContactProblem& problem, const ContactSolution& solution,
                                               const std::vector<Adjoint>& outputs, const Observer& observer);

}  // namespace contactd

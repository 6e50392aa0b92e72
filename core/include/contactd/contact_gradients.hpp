// Computes gradients of the answers of a solved contact by the transpose of its linearised equations.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/gradients.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Bounds of the number of outputs at once, and of Cotangents::norm_order.
inline constexpr std::size_t most_outputs = 100;
inline constexpr double largest_norm_order = 1000;

struct ContactGradients {
    std::vector<Gradient> outputs;  ///< one per output, empty without contact or if the equations did not converge
    SolverEvidence evidence;        ///< total number of iterations and largest residual of the linear equations
    std::vector<std::string> warnings;
};

/// Throws InvalidArgument ("vjp", or a field of it) if the problem or an output has no gradients: simplified models,
/// curved columns, penetration, viscoelastic bodies, slip laws, friction by temperature, layers that yield, more than
/// one step, and arrays of the wrong size.
void validate_gradients(const ContactProblem& problem, const std::vector<Cotangents>& outputs,
                        const std::vector<GradientInput>& by);

/// Returns the gradient of each output. `solution` is that of solve_contact for the same problem and operators; it must
/// have converged. All outputs share the steps of the solver. Throws InvalidArgument as validate_gradients, also if the
/// operators violate reciprocity, and Cancelled.
ContactGradients contact_gradients(const ContactProblem& problem, const ContactInfluence& influence,
                                   const ContactSolution& solution, const std::vector<Cotangents>& outputs,
                                   const std::vector<GradientInput>& by, Observer& observer);

}  // namespace contactd

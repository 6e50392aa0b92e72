// Computes the effects of tractions on slip and distance, and those of their adjoints on previous tractions.
#pragma once

#include <vector>

#include "contact/support/contact_elements.hpp"
#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/gradients.hpp"

namespace contactd {

// Holds slip over the step (mm) and displacement along z (mm) due to elastic deformation, on the whole grid, divided
// into the effects of tractions on slip and of pressures on distance, and their coupling.
struct ElasticEffects {
    Field slip, slip_by_coupling;
    std::vector<double> normal, normal_by_coupling;
};

// Returns the effects of the tractions of the solution and, except in steady rolling, of those before the step.
ElasticEffects elastic_effects(const ContactProblem& problem, const ContactInfluence& influence,
                               const ContactSolution& solution);

// Returns the derivatives with respect to the tractions before the step, from those with respect to the slip (mm) of
// each element.
GradientByPrevious by_previous(const ContactProblem& problem, const ContactInfluence& influence,
                               const ContactSolution& solution, const Field& slip);

}  // namespace contactd

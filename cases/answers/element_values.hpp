// Values of elements as the other program has them, from a solution of core.
#pragma once

#include <vector>

#include "contactd/contact.hpp"

namespace contactd::cases {

/// Plastic deformation of an interfacial layer that its particles have accumulated since they entered (mm), an element
/// each, along the tractions on the upper body. Empty without a layer that yields.
struct PlasticSlip {
    std::vector<double> x, y;
};

/// Makes the solution that of elements. Pressures that are prescribed have the force that was set with them, which
/// their sum misses by the error of the grid. Simplified theories in Hertz's ellipse have the areas of their elements
/// and the largest of their pressures, which are the paraboloid where FASTSIM is bounded by it. Elements that slip are
/// not plastic, though their layer has flowed before, and elements without friction adhere.
void take_elements(const ContactProblem& problem, ContactSolution& solution, bool rubs);

/// Adds the flow of the step to what particles brought: `before` in a step that goes on, nothing where it is empty, and
/// in steady rolling what came from the leading edge. Particles keep it behind the contact in steady rolling, as they
/// keep the yield stress, and leave it behind elsewhere.
PlasticSlip plastic_slip(const ContactProblem& problem, const ContactSolution& solution, const PlasticSlip& before);

/// Returns the yield stress of the layer (N/mm^2), in steady rolling also of particles behind the contact. Empty
/// without a layer that yields.
std::vector<double> yield_stress(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd::cases

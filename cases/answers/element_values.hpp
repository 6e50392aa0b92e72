// Computes values of elements in CONTACT's conventions, from a solution of core.
#pragma once

#include <vector>

#include "contactd/contact.hpp"

namespace contactd::cases {

/// Holds plastic deformation of an interfacial layer that its particles have accumulated since they entered (mm), for
/// each element, along the tractions on the upper body. Empty without a layer that yields.
struct PlasticSlip {
    std::vector<double> x, y;
};

/// Changes the solution to CONTACT's values of elements. Prescribed pressures have the prescribed force instead of
/// their sum, which contains the error of the grid. Simplified theories in Hertz's ellipse have the areas of their
/// elements and the largest pressure of the elements. With FASTSIM and a parabolic bound, pressures are those of the
/// paraboloid. Elements that slip are not plastic, even if their layer has flowed, and elements without friction
/// adhere.
void take_elements(const ContactProblem& problem, ContactSolution& solution, bool rubs);

/// Adds the flow of the step to the slip that particles have accumulated: `before` in a step that continues, zero if
/// that is empty, and in steady rolling the slip since the leading edge. In steady rolling, particles behind the
/// contact keep their slip, like the yield stress. Otherwise it is zero outside the contact.
PlasticSlip plastic_slip(const ContactProblem& problem, const ContactSolution& solution, const PlasticSlip& before);

/// Returns the yield stress of the layer (N/mm^2), in steady rolling also behind the contact. Empty without a layer
/// that yields.
std::vector<double> yield_stress(const ContactProblem& problem, const ContactSolution& solution);

}  // namespace contactd::cases

// Rolling by the models of vehicle codes: FASTSIM on elements, FaStrip, Polach.
#pragma once

#include <string>
#include <vector>

#include "closed_forms/forces_by_motion.hpp"
#include "element_patch.hpp"

namespace contactd {

/// Tells whether FASTSIM goes by elements: for falling friction, a reduced slope, an elliptic bound, blended or printed
/// flexibilities, or because it is asked to.
bool needs_elements(const ContactSetup& setup);

/// Tells whether a model of rolling is one of those of this file, for this set-up.
bool rolls_on_elements(const ContactSetup& setup);

/// Steady rolling of `problem`, which has friction of one coefficient, on a patch. That falls with the velocity
/// V sqrt(xi^2 + eta^2) of the whole contact. Forces, areas and power are sums over elements; Polach has neither
/// tractions nor a moment: forces only, and all of the contact counts as slip. Motions that forces prescribe are
/// searched. Adds warnings. Throws InvalidArgument ("friction.rolling.chi", "friction.rolling.force", "gap").
EllipticFriction element_friction(const ContactProblem& problem, const ElementPatch& patch,
                                  std::vector<std::string>& warnings);

/// Differentiates the forces at known creepages. `patch` is not empty, mu > 0 and does not fall.
ForcesByMotion element_friction_by_motion(const ContactProblem& problem, const ElementPatch& patch,
                                          const Rolling& rolling);

}  // namespace contactd
